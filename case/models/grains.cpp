#include "case/models/grains.hpp"

#include <algorithm>
#include <cmath>

#include "case/case.hpp"
#include "case/models/driven_flow.hpp"
#include "case/models/surface_bed.hpp"

namespace thalweg {

Grains grains_of(const Case& of) {
  const SedimentParameters& s = of.sediment();
  Grains grains;
  grains.density = s.grain_density;
  grains.diameter = s.grain_diameter;
  grains.porosity = s.porosity;
  grains.tan_friction = std::tan(s.friction_angle);
  grains.lift_ratio = s.lift_ratio;
  grains.roughness = roughness_of_current(of);
  grains.gravity = of.domain.gravity.norm();
  grains.critical_shields = critical_shields_of(s, of.water.density, grains.gravity);
  grains.water_density = of.water.density;
  grains.water_viscosity = of.water.viscosity / of.water.density;
  grains.bed_load = of.model.bed_load;
  grains.slope_effect = of.model.slope_effect;
  grains.pick_up = of.suspended_load.pick_up;
  grains.adaptation = of.surface_bed.adaptation;
  return grains;
}

double reference_level_of(const Case& of) {
  const double given = of.suspended_load.reference_level;
  return given > 0 ? given : roughness_of_current(of);
}

double grain_stress_of(const Case& of) { return models::SurfaceBedOfCase::is_on(of) ? of.surface_bed.grain_stress : 1; }

double suspended_settling_velocity(const Case& of) {
  Grains grains = grains_of(of);
  if (of.suspended_load.diameter > 0) grains.diameter = of.suspended_load.diameter;
  return grains.settling(0);
}

double reference_concentration(const Grains& of, double friction_velocity, double settling_velocity) {
  const BedStress stress = bed_stress_of(of, friction_velocity, 1, 0);
  return std::min(pick_up_of(of, stress, stress.flat_critical) / settling_velocity, 1 - of.porosity);
}

}  // namespace thalweg
