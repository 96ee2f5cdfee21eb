#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg::foam {

/// How the mesh model sees the sediment, by the place of its name in mesh_model_names:
///   same_material   a phase of multiphaseInterFoam with the particle model's own laws (foam_reference/library)
///   eroding_bed     a packed bed beneath interFoam that bed load and suspension wear down (foam_reference/library)
///   stock           a phase of multiphaseInterFoam with OpenFOAM's HerschelBulkley: needs no library
enum class FoamModel { same_material, eroding_bed, stock };

/// "same-material", as the case file and the folder of results name it.
std::string name_of(FoamModel model);

/// The model of a name. Throws InputError that lists the names.
FoamModel model_of(const std::string& name);

/// The models to run: foam.models; without it both of our own, or without sediment, where they are the same, `stock`.
std::vector<FoamModel> models_of(const Case& scene);

/// Whether the model of this scene needs libthalwegFoam.
bool needs_library(const Case& scene, FoamModel model);

/// The solver of OpenFOAM that computes it: "multiphaseInterFoam" or "interFoam".
std::string application_of(FoamModel model);

}  // namespace thalweg::foam
