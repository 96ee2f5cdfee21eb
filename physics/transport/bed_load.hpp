#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Bed load: grains that roll and jump along a bed, as volume of grains without pores per second and metre of width
// [m^2/s]. Symbols: Shields numbers theta of the bed and theta_cr at its first motion [-]; grain diameter d [m];
// densities of grain rho_s and water rho_w [kg/m^3]; gravity g [m/s^2].
namespace thalweg {

/// Law for the bed load.
///   meyer_peter_mueller   8 (theta - theta_cr)^1.5; the default
///   van_rijn              van Rijn 1984, for sands of 0.2 to 2 mm
enum class BedLoad { meyer_peter_mueller, van_rijn };

/// Unit of bed load, sqrt((rho_s/rho_w - 1) g d^3) [m^2/s] (Einstein). PVC of 3.5 mm, 1540 kg/m^3: 4.76577e-4 m^2/s.
template <class Real>
HOST_DEVICE inline Real bed_load_scale(Real diameter, Real grain_density, Real water_density, Real gravity) {
  using std::sqrt;
  return diameter * sqrt((grain_density / water_density - 1) * gravity * diameter);
}

/// Bed load over its unit [-], Meyer-Peter & Mueller 1948 (2nd Meeting IAHR, Stockholm):
///   8 (theta - theta_cr)^1.5,   0 for theta <= theta_cr
/// Limits: fitted to gravels of 0.4 to 29 mm at theta up to about 0.25, with theta_cr = 0.047; it has no upper bound.
/// theta = 0.4, theta_cr = 0.047: 1.677846.
template <class Real>
HOST_DEVICE inline Real meyer_peter_mueller(Real shields, Real critical_shields) {
  using std::sqrt;
  const Real excess = shields - critical_shields;
  return excess > 0 ? 8 * excess * sqrt(excess) : Real(0);
}

/// Bed load over its unit [-], van Rijn 1984 (J. Hydraul. Eng. 110, 1431-1456):
///   0.053 T^2.1/d*^0.3,   T = theta/theta_cr - 1,   0 for T <= 0
/// T transport stage [-], d* dimensionless diameter [-] (lift_settling.hpp). Limits: d of 0.2 to 2 mm, T up to 15.
/// theta = 0.4, theta_cr = 0.05 (T = 7), d* = 61.01: 0.919097.
template <class Real>
HOST_DEVICE inline Real van_rijn_bed_load(Real shields, Real critical_shields, Real dimensionless_diameter) {
  using std::pow;
  const Real stage = shields / critical_shields - 1;
  if (!(stage > 0)) return 0;
  return Real(0.053) * pow(stage, Real(2.1)) / pow(dimensionless_diameter, Real(0.3));
}

}  // namespace thalweg
