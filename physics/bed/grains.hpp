#pragma once

#include <cmath>

#include "physics/bed/grain_columns.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/transport/bed_load_drift.hpp"
#include "physics/transport/bed_shear.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/friction_velocity.hpp"
#include "physics/transport/lift_settling.hpp"
#include "physics/transport/pick_up.hpp"
#include "physics/transport/saltation_length.hpp"
#include "physics/transport/slope_effect.hpp"
#include "physics/transport/slope_factor.hpp"

// Grains that water moves over a bed of columns: the laws of physics/transport, composed.
namespace thalweg {

/// Constants of grains and water, SI.
struct Grains {
  double density = 0;           // [kg/m^3] of the grains
  double diameter = 0;          // [m]
  double porosity = 0;          // [-]
  double tan_friction = 0;      // [-]
  double lift_ratio = 0;        // [-]
  double roughness = 0;         // [m] ks
  double critical_shields = 0;  // [-]; 0: by the grain Reynolds number
  double water_density = 0;     // [kg/m^3]
  double water_viscosity = 0;   // [m^2/s]
  double gravity = 0;           // [m/s^2]
  BedLoad bed_load = BedLoad::meyer_peter_mueller;
  SlopeEffect slope_effect = SlopeEffect::friction;
  PickUp pick_up = PickUp::mastbergen;
  BedLoadAdaptation adaptation = BedLoadAdaptation::none;

  /// Dimensionless diameter d* [-].
  [[nodiscard]] double size_number() const {
    return dimensionless_diameter(diameter, density, water_density, gravity, water_viscosity * water_density);
  }
  /// Settling velocity [m/s] among grains of this volume share [-].
  [[nodiscard]] double settling(double share) const {
    return hindered_settling_velocity(size_number(), share, diameter, water_viscosity);
  }
};

/// Stress of the water on a place of the bed.
struct BedStress {
  double friction_velocity = 0;  // u* [m/s]
  double shields = 0;            // [-]
  double flat_critical = 0;      // [-] Shields number at which a flat bed begins to move
  double along_x = 0;            // [-] direction of the flow over the ground, a unit vector
  double along_y = 0;            // [-]
};

/// Stress of water with the friction velocity [m/s] over the ground along the unit vector (along_x, along_y).
inline BedStress bed_stress_of(const Grains& of, double friction_velocity, double along_x, double along_y) {
  BedStress found;
  if (!(friction_velocity > 0)) return found;
  const double weight = grain_weight_stress(of.density, of.water_density, of.gravity, of.diameter);
  found.friction_velocity = friction_velocity;
  found.shields = shields_number(bed_shear_stress(of.water_density, found.friction_velocity), weight);
  found.flat_critical = of.critical_shields > 0
                            ? of.critical_shields
                            : critical_shields_number(found.friction_velocity * of.diameter / of.water_viscosity);
  found.along_x = along_x;
  found.along_y = along_y;
  return found;
}

/// Stress of water that moves with `speed` [m/s] along the bed, at `height` [m] above it.
inline BedStress bed_stress(const Grains& of, double speed, double height, double along_x, double along_y) {
  if (!(speed > 0)) return {};
  return bed_stress_of(of, friction_velocity(speed, height, of.water_viscosity, of.roughness).friction_velocity,
                       along_x, along_y);
}

/// Shields number [-] at which a bed of the slopes (slope_x, slope_y) [-] begins to move. Not below a twentieth of the
/// flat bed's, since a steep slope makes it 0 and van Rijn's laws divide by it.
inline double critical_on_slope(const Grains& of, const BedStress& stress, double slope_x, double slope_y) {
  const double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  const Vec<3, double> normal{{-slope_x / length, -slope_y / length, 1 / length}};
  const Vec<3, double> flow{{stress.along_x, stress.along_y, stress.along_x * slope_x + stress.along_y * slope_y}};
  const Vec<3, double> down{{0, 0, -1}};
  const double factor = slope_factor(normal, flow, down, of.tan_friction, of.lift_ratio);
  return stress.flat_critical * (factor > 0.05 ? factor : 0.05);
}

/// Bed load along the flow, volume of grains per second and metre of width [m^2/s]. critical: Shields number at which
/// the bed begins to move here [-].
inline double bed_load_of(const Grains& of, const BedStress& stress, double critical) {
  if (!(stress.shields > critical)) return 0;
  const double scale = bed_load_scale(of.diameter, of.density, of.water_density, of.gravity);
  return scale * bed_load(of.bed_load, stress.shields, critical, of.size_number());
}

/// Volume of grains that rise from the bed per second and area [m/s].
inline double pick_up_of(const Grains& of, const BedStress& stress, double critical) {
  if (!(stress.shields > critical)) return 0;
  switch (of.pick_up) {
    case PickUp::van_rijn:
      return van_rijn_pick_up(stress.shields, critical, of.size_number(), of.diameter, of.density, of.water_density,
                              of.gravity);
    case PickUp::mastbergen:
      break;
  }
  return lift_velocity(stress.shields, critical, of.size_number(), of.diameter, of.density, of.water_density,
                       of.gravity);
}

/// Bed load [m^2/s] that a column sends to its neighbour along an axis, or out of an open end, >= 0.
///
/// A grain that crosses between two columns climbs or falls from one to the other: along that axis the slope between them
/// decides, not the mean slope at either. With the slope s along the flow e and the slope across it,
///   q = q_law(theta, theta_cr on the slope) F [e - T (grad z - s e)]
/// F the factor of the slope along the flow (slope_effect.hpp), T the pull of that across it (bed_load_drift.hpp). Nothing
/// climbs what is steeper than the grains stand.
inline double bed_load_between(const GrainColumns& bed, const Grains& of, const BedStress& stress, int column, int axis,
                               bool forward) {
  if (!(stress.friction_velocity > 0)) return 0;
  const double sign = forward ? 1 : -1;
  const double between = bed.open_neighbour(column, axis, forward) >= 0 ? bed.slope_between(column, axis, forward) : 0;
  if (sign * between >= of.tan_friction) return 0;
  const double across = bed.slope(column, 1 - axis);
  const double slope[2] = {axis == 0 ? between : across, axis == 0 ? across : between};
  const double along[2] = {stress.along_x, stress.along_y};
  const double critical = critical_on_slope(of, stress, slope[0], slope[1]);
  const double law = bed_load_of(of, stress, critical);
  if (!(law > 0)) return 0;
  const double rise = along[0] * slope[0] + along[1] * slope[1];
  const double pull = transverse_slope(critical / stress.shields);
  const double sent = law * bed_load_slope_factor(of.slope_effect, rise, of.tan_friction) *
                      (along[axis] - pull * (slope[axis] - rise * along[axis])) * sign;
  return sent > 0 ? sent : 0;
}

}  // namespace thalweg
