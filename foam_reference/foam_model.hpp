#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg::foam {

/// Model of the sediment on the mesh. The order is that of mesh_model_names.
///   same_material   a phase of multiphaseInterFoam with the particle model's own laws (foam_reference/library)
///   eroding_bed     a packed bed beneath interFoam that bed load and suspension erode (foam_reference/library)
///   stock           a phase of multiphaseInterFoam with OpenFOAM's own HerschelBulkley; needs no library
enum class FoamModel { same_material, eroding_bed, stock };

/// "same-material", as the case file and the folder of results name it.
std::string name_of(FoamModel model);

/// The model of a name. Throws InputError that lists the names.
FoamModel model_of(const std::string& name);

/// The models to run: those of foam.models, or both of our own if the case names none; of a current over sediment the
/// eroding bed alone, since the law of the wall needs a bed that is no phase. Without sediment all models are the same,
/// and `stock` alone is run.
std::vector<FoamModel> models_of(const Case& scene);

/// True if the model of this scene needs libthalwegFoam: for its sediment, or for the drive around a period.
bool needs_library(const Case& scene, FoamModel model);

/// OpenFOAM's solver for the model: "multiphaseInterFoam", or "interFoam" for the eroding bed and for water alone that a
/// current or eddies of a k-omega model move.
std::string application_of(const Case& scene, FoamModel model);

}  // namespace thalweg::foam
