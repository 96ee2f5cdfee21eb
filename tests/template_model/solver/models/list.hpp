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
#include "tests/template_model/tracer/model.hpp"

// Stands for solver/models/list.hpp in the test of the template model: the same list and one line more. The build puts
// this folder before the repository's root on the include path.
namespace thalweg {

/// The list. Within a stage models run in this order.
using AllModels =
    ModelList<MixtureModel, MovingWallsModel, BedModel, NoSlipModel, ViscosityModel, PoreModel, SubParticleModel,
              StatesModel, BedLoadModel, RestModel, WallStressModel, SuspendedLoadModel, ThinFilmModel, ShiftingModel,
              MixingLengthModel, CurrentModel, OpeningsModel, SurfaceBedModel, TracerModel>;

}  // namespace thalweg
