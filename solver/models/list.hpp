#pragma once

#include "solver/models/bed/model.hpp"
#include "solver/models/bed_load/model.hpp"
#include "solver/models/current/model.hpp"
#include "solver/models/implicit/model.hpp"
#include "solver/models/mixing_length/model.hpp"
#include "solver/models/moving_walls/model.hpp"
#include "solver/models/no_slip/model.hpp"
#include "solver/models/openings/model.hpp"
#include "solver/models/pore_pressure/model.hpp"
#include "solver/models/rest/model.hpp"
#include "solver/models/seepage/model.hpp"
#include "solver/models/shifting/model.hpp"
#include "solver/models/stages.hpp"
#include "solver/models/states/model.hpp"
#include "solver/models/sub_particle/model.hpp"
#include "solver/models/surface_bed/model.hpp"
#include "solver/models/suspended_load/model.hpp"
#include "solver/models/thin_film/model.hpp"
#include "solver/models/wall_stress/model.hpp"

// The models that a solver has. A model is a struct of static functions (models/NAME/model.hpp) and may bring
//
//   Parameters<Dim>     a struct of constants; Scene has its members
//   make(from, scene)   fills them from the case (models/NAME/make.cpp)
//   Arrays<Device>      particle arrays and their describe(); Particles has its members
//   Work<Device>        what it keeps between steps; Workspace has its members
//   is_on(scene)        true if a scene uses it; nothing of the above costs anything where it does not
//   heading             its line in the timing report
//   stages              functions named in models/stages.hpp, each at its place in the step
//   limit_step, varies  models/stages.hpp, ModelList
//
// tests/template_model is a model to copy.
namespace thalweg {

/// The list. Within a stage models run in this order.
using AllModels =
    ModelList<MixtureModel, MovingWallsModel, BedModel, NoSlipModel, ViscosityModel, PoreModel, SubParticleModel,
              StatesModel, BedLoadModel, RestModel, WallStressModel, SuspendedLoadModel, ThinFilmModel, ShiftingModel,
              MixingLengthModel, CurrentModel, OpeningsModel, SurfaceBedModel>;

}  // namespace thalweg
