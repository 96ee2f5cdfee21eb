#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Grains that leave a bed and fall back, the paper's (23). Symbols: densities of grain rho_s and water rho_w [kg/m^3];
// gravity g [m/s^2]; grain diameter d [m]; dynamic viscosity mu [Pa s] and kinematic viscosity nu [m^2/s] of the water.
namespace thalweg {

/// Dimensionless grain diameter d* = d [rho_w (rho_s - rho_w) g/mu^2]^(1/3) [-].
/// PVC of 3.5 mm, 1540 kg/m^3 in water: 61.01.
template <class Real>
HOST_DEVICE inline Real dimensionless_diameter(Real diameter, Real grain_density, Real water_density, Real gravity,
                                               Real dynamic_viscosity) {
  using std::cbrt;
  const Real weight = water_density * (grain_density - water_density) * gravity;
  return diameter * cbrt(weight / (dynamic_viscosity * dynamic_viscosity));
}

/// Velocity with which grains are lifted off a bed along its normal [m/s], Mastbergen & van den Berg 2003
/// (Sedimentology 50, 625-637):
///   alpha d*^0.3 (theta - theta_cr)^1.5 sqrt(g d (rho_s - rho_w)/rho_w),   0 for theta <= theta_cr
/// Shields numbers theta and theta_cr [-]; entrainment alpha [-], 0.018 is FLOW-3D's default.
/// PVC of 3.5 mm: 0.00841 (theta - theta_cr)^1.5 m/s, forty times below its settling velocity at theta = 0.6.
template <class Real>
HOST_DEVICE inline Real lift_velocity(Real shields, Real critical_shields, Real dimensionless_diameter, Real diameter,
                                      Real grain_density, Real water_density, Real gravity,
                                      Real entrainment = Real(0.018)) {
  using std::pow;
  using std::sqrt;
  const Real excess = shields - critical_shields;
  if (!(excess > 0)) return 0;
  const Real scale = sqrt(gravity * diameter * (grain_density - water_density) / water_density);
  return entrainment * pow(dimensionless_diameter, Real(0.3)) * excess * sqrt(excess) * scale;
}

/// Settling velocity of a single grain in still water [m/s], Soulsby 1997 (Dynamics of Marine Sands):
///   (nu/d) { [10.36^2 + 1.049 d*^3]^(1/2) - 10.36 }
/// Limits: natural sands of all sizes; nu d*^3/(19.75 d), as by Stokes, for small d*. The difference is coded by its
/// conjugate, which keeps the digits of a small d*. PVC of 3.5 mm: 0.1365 m/s.
template <class Real>
HOST_DEVICE inline Real settling_velocity(Real dimensionless_diameter, Real diameter, Real kinematic_viscosity) {
  using std::sqrt;
  const Real a = Real(10.36);
  const Real b = Real(1.049) * dimensionless_diameter * dimensionless_diameter * dimensionless_diameter;
  return kinematic_viscosity / diameter * b / (sqrt(a * a + b) + a);
}

/// Settling velocity of grains among others [m/s], Soulsby 1997: d*^3 in settling_velocity() becomes (1 - C)^4.7 d*^3.
/// C volume share of the grains [-], taken within [0, 1]. PVC of 3.5 mm at C = 0.1: 0.10595 m/s.
template <class Real>
HOST_DEVICE inline Real hindered_settling_velocity(Real dimensionless_diameter, Real volume_share, Real diameter,
                                                   Real kinematic_viscosity) {
  using std::pow;
  const Real between = 1 - volume_share;
  const Real water = between < 1 ? (between > 0 ? between : Real(0)) : Real(1);
  return settling_velocity(dimensionless_diameter * pow(water, Real(4.7 / 3)), diameter, kinematic_viscosity);
}

}  // namespace thalweg
