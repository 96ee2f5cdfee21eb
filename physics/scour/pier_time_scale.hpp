#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of pier_time_scale().
struct PierTimeScale {
  double diameter = 0;          // D [m]
  double depth = 0;             // delta [m], thickness of the boundary layer: the depth in a developed current
  double shields = 0;           // theta [-], of the flat bed away from the pier, by skin friction
  double critical_shields = 0;  // [-]
  double grain_diameter = 0;    // d [m]
  double relative_density = 0;  // s [-]
  double gravity = 9.81;        // g [m/s^2]
};

/// Time scale T [s] of scour at a slender circular pile in a current, S(t) = S_eq (1 - exp(-t/T)):
///   T sqrt(g (s - 1) d^3)/D^2 = (1/2000) (delta/D) theta^-2.2
/// Source: Sumer, Christiansen & Fredsoe 1992 (Proc. 2nd ISOPE Conf. 3, 308-315), live bed.
/// D = 0.1 m, delta = 0.2 m, theta = 0.1, d = 0.3 mm, s = 2.65: 75.8 s.
inline double pier_time_scale(const PierTimeScale& pier) {
  const double d = pier.grain_diameter;
  const double unit = pier.diameter * pier.diameter / std::sqrt(pier.gravity * (pier.relative_density - 1) * d * d * d);
  return unit * pier.depth / pier.diameter * std::pow(pier.shields, -2.2) / 2000;
}

/// Limits left: theta/theta_cr >= 1 (live bed).
inline std::vector<LimitLeft> limits_left(const PierTimeScale& pier) {
  return Limits().at_least("theta/theta_cr", pier.shields / pier.critical_shields, 1).left();
}

}  // namespace thalweg
