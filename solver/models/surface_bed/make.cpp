#include <cmath>

#include "case/models/driven_flow.hpp"
#include "case/models/grains.hpp"
#include "case/models/surface_bed.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/models/surface_bed/make_bed_rows.hpp"

namespace thalweg {

template <int Dim>
void SurfaceBedModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.surface_bed.on = models::SurfaceBedOfCase::is_on(from.of);
  if (!scene.surface_bed.on) return;
  scene.surface_bed.roughness = static_cast<float>(roughness_of_current(from.of));
  scene.surface_bed.grain_stress = static_cast<float>(grain_stress_of(from.of));
  scene.surface_bed.tan_friction = static_cast<float>(std::tan(from.of.sediment().friction_angle));
  scene.surface_bed.density = scene.water_density;
  scene.surface_bed.rows_in_reach = rows_in_reach(scene.smoothing_length, scene.spacing);
  scene.walls_move = true;
  scene.keeps_wall_shear = true;
}

template void SurfaceBedModel::make(const SceneSource&, Scene<2>&);
template void SurfaceBedModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
