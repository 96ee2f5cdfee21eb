#include "foam_reference/foam_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/models/surface_bed.hpp"
#include "common/error.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {

std::string name_of(FoamModel model) { return mesh_model_names.at(static_cast<std::size_t>(model)); }

FoamModel model_of(const std::string& name) {
  const auto found = std::ranges::find(mesh_model_names, name);
  if (found != mesh_model_names.end()) return static_cast<FoamModel>(found - mesh_model_names.begin());
  throw InputError(
      fmt::format("there is no mesh model \"{}\"; the models are {}", name, fmt::join(mesh_model_names, ", ")));
}

std::vector<FoamModel> models_of(const Case& scene) {
  if (!scene.has_sediment()) return {FoamModel::stock};
  const bool moves_surface = has_current(scene) || models::SurfaceBedOfCase::is_on(scene);
  if (scene.foam.models.empty() && moves_surface) return {FoamModel::eroding_bed};
  if (scene.foam.models.empty()) return {FoamModel::same_material, FoamModel::eroding_bed};
  std::vector<FoamModel> models;
  for (const std::string& name : scene.foam.models) models.push_back(model_of(name));
  return models;
}

bool needs_library(const Case& scene, FoamModel model) {
  if (scene.flow.drive != Drive::off) return true;
  switch (model) {
    case FoamModel::same_material:
    case FoamModel::eroding_bed:
      return scene.has_sediment();
    case FoamModel::stock:
      break;
  }
  return false;
}

std::string application_of(const Case& scene, FoamModel model) {
  const bool is_mixed = has_current(scene) || scene.foam.turbulence == FoamTurbulence::k_omega;
  if (!scene.has_sediment()) return is_mixed ? "interFoam" : "multiphaseInterFoam";
  switch (model) {
    case FoamModel::eroding_bed:
      return "interFoam";
    case FoamModel::same_material:
    case FoamModel::stock:
      break;
  }
  return "multiphaseInterFoam";
}

}  // namespace thalweg::foam
