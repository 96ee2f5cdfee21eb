#include "foam_reference/wall_patches.hpp"

#include <algorithm>

namespace thalweg::foam {

double roughness_of(const FoamCase& foam_case, const Shape& shape) {
  const Case& scene = foam_case.scene;
  const bool counts = foam_case.has_wall_functions() && scene.model.wall_friction == WallFriction::rough;
  return counts ? shape.roughness : 0;
}

std::vector<double> solid_roughnesses(const FoamCase& foam_case) {
  std::vector<double> found;
  for (const Shape& shape : foam_case.scene.shapes) {
    if (shape.role != ShapeRole::wall || is_container(shape) || is_meshed_solid(foam_case.scene, shape)) continue;
    const double roughness = roughness_of(foam_case, shape);
    if (std::ranges::find(found, roughness) == found.end()) found.push_back(roughness);
  }
  return found;
}

std::string solids_patch(std::size_t index) { return "solids" + (index > 0 ? std::to_string(index) : ""); }

std::vector<WallPatch> wall_patches(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  std::vector<WallPatch> patches;
  if (foam_case.plan.open(Face::wall)) {
    const auto container = std::ranges::find_if(scene.shapes, is_container);
    patches.push_back({"walls", container != scene.shapes.end() ? roughness_of(foam_case, *container) : 0});
  }
  const std::vector<double> solids = solid_roughnesses(foam_case);
  for (std::size_t i = 0; i < solids.size(); ++i) patches.push_back({solids_patch(i), solids[i]});
  for (const Shape& shape : scene.shapes) {
    if (!is_meshed_solid(scene, shape)) continue;
    patches.push_back({"surface" + std::to_string(&shape - scene.shapes.data()), roughness_of(foam_case, shape)});
  }
  return patches;
}

}  // namespace thalweg::foam
