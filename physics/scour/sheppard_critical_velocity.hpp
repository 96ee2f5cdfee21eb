#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Critical Shields number [-] of a flat bed by the dimensionless grain diameter d* [-], as the Florida Bridge Scour
/// Manual (Sheppard & Renna 2010) uses it with the S/M formula:
///   0.25 - 0.1 sqrt(d*)                               d* <= 3
///   0.0023 d* - 0.000378 d* ln d* + 0.23/d* - 0.005   3 < d* <= 150
///   0.0575                                            d* > 150
/// d* = 10: 0.0323; the pieces meet within 1 %.
HOST_DEVICE inline double sheppard_critical_shields(double dimensionless_diameter) {
  const double d = dimensionless_diameter;
  if (d <= 3) return 0.25 - 0.1 * std::sqrt(d);
  if (d > 150) return 0.0575;
  return 0.0023 * d - 0.000378 * d * std::log(d) + 0.23 / d - 0.005;
}

/// Mean velocity [m/s] at which grains of a flat bed begin to move (Florida Bridge Scour Manual, as above):
///   V_c = 2.5 u*_c ln(y/(2.72 z0)),   u*_c = sqrt(theta_c (s - 1) g d)
/// with the roughness ks = 2.5 d (5 d for d < 0.6 mm) and, R = u*_c ks/nu,
///   z0 = nu/(9 u*_c)                                                              R <= 5
///   z0 = ks/1000 (-6 + 2.85 R - 0.58 R ln R + 0.002 R^2 + 111/R)            5 < R <= 70
///   z0 = ks/30                                                                    R > 70
/// y depth [m]; d grain diameter [m]; s relative density of the grains [-]; g [m/s^2]; nu [m^2/s].
/// y = 1 m, d = 1 mm, s = 2.65: 0.4767 m/s.
HOST_DEVICE inline double sheppard_critical_velocity(double depth, double grain_diameter, double relative_density,
                                                     double gravity, double viscosity) {
  const double weight = (relative_density - 1) * gravity;
  const double d_star = grain_diameter * std::cbrt(weight / (viscosity * viscosity));
  const double u = std::sqrt(sheppard_critical_shields(d_star) * weight * grain_diameter);
  const double roughness = (grain_diameter < 0.6e-3 ? 5 : 2.5) * grain_diameter;
  const double R = u * roughness / viscosity;
  double z0 = roughness / 30;
  if (R <= 5) {
    z0 = viscosity / (9 * u);
  } else if (R <= 70) {
    z0 = 1e-3 * roughness * (-6 + 2.85 * R - 0.58 * R * std::log(R) + 0.002 * R * R + 111 / R);
  }
  return 2.5 * u * std::log(depth / (2.72 * z0));
}

}  // namespace thalweg
