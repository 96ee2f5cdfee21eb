#include "solver/models/openings/make_grains_of_inlets.hpp"

#include <cmath>

#include "case/models/grains.hpp"
#include "case/models/suspended_load.hpp"
#include "physics/transport/rouse.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg {

GrainsOfInlets::GrainsOfInlets(const Case& of) : viscosity_(of.water.viscosity / of.water.density) {
  if (!models::SuspendedLoadOfWater::is_on(of)) return;
  bed_ = grains_of(of);
  density_ = bed_.density;
  settling_velocity_ = suspended_settling_velocity(of);
  reference_level_ = reference_level_of(of);
  grain_stress_ = grain_stress_of(of);
}

double GrainsOfInlets::concentration(const Inlet& inlet, double height, double depth, double velocity,
                                     double bed_stress) const {
  if (inlet.grains != InletGrains::equilibrium) {
    return inlet.concentration_at(height, depth, velocity, viscosity_, settling_velocity_);
  }
  const double friction = bed_stress > 0 ? std::sqrt(bed_stress / bed_.water_density)
                                         : friction_velocity_of_current(velocity, depth, viscosity_, inlet.roughness);
  return reference_concentration(bed_, std::sqrt(grain_stress_) * friction, settling_velocity_) *
         rouse_share(height, reference_level_, depth, friction, settling_velocity_);
}

}  // namespace thalweg
