#include <cmath>

#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "case/models/three_state.hpp"
#include "physics/sediment/surface_fill.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/lift_settling.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/models/states/flat_bed.hpp"

namespace thalweg {

template <int Dim>
void StatesModel::make(const SceneSource& from, Scene<Dim>& scene) {
  const Case& of = from.of;
  scene.has_states = scene.has_sediment && models::ThreeState::is_on(of);
  const bool lifts_off_surface = models::SurfaceBedOfCase::is_on(of) && models::SuspendedLoadOfWater::is_on(of);
  if (!scene.has_states && !lifts_off_surface) return;
  const SedimentParameters& s = of.sediment();
  const double g = of.domain.gravity.norm();
  const double rho = of.water.density;
  const double viscosity = of.water.viscosity;
  const double d_star = dimensionless_diameter(s.grain_diameter, s.grain_density, rho, g, viscosity);
  ErosionScene<Dim>& law = scene.erosion;
  law.bed_shear = of.model.bed_shear;
  law.as_printed = of.model.implementation == Implementation::paper;
  law.by_law = of.model.implementation == Implementation::law;
  law.surface_fill = law.as_printed ? surface_fill_as_printed
                                    : surface_fill(of.numerics.smoothing_ratio, 1, widest_narrow_kernel_of_states);
  law.fill_hysteresis = law.as_printed ? 0 : surface_fill_hysteresis;
  law.diameter = static_cast<float>(s.grain_diameter);
  law.roughness = static_cast<float>(s.roughness > 0 ? s.roughness : s.grain_diameter);
  know_flat_beds(scene);
  law.grain_density = static_cast<float>(s.grain_density);
  law.grain_weight = static_cast<float>(grain_weight_stress(s.grain_density, rho, g, s.grain_diameter));
  law.cohesion = s.critical_stress > 0 ? 0 : static_cast<float>(s.cohesion);
  law.gravity = static_cast<float>(g);
  for (int k = 0; k < Dim; ++k) law.down[k] = static_cast<float>(of.domain.gravity[axis<Dim>(k)] / g);
  law.critical_shields = static_cast<float>(critical_shields_of(s, rho, g));
  law.lift_ratio = static_cast<float>(s.lift_ratio);
  law.dimensionless_diameter = static_cast<float>(d_star);
  law.settling_velocity = static_cast<float>(settling_velocity(d_star, s.grain_diameter, viscosity / rho));
  law.dilute = static_cast<float>(s.dilute_concentration);
  law.dense = static_cast<float>(s.dense_concentration);
  law.return_stress = static_cast<float>(s.deposition_stress);
  law.return_speed = static_cast<float>(s.deposition_speed * std::sqrt(g * s.grain_diameter));
  law.return_time = static_cast<float>(std::sqrt(s.grain_diameter / g));
  law.solids_share = law.as_printed ? 1 : static_cast<float>(1 - s.porosity);
  law.einstein_coefficient = law.as_printed ? 0.5F : 2.5F;
}

template void StatesModel::make(const SceneSource&, Scene<2>&);
template void StatesModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
