#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Law by which grains of a bed come into suspension.
///   mastbergen   the lift velocity of Mastbergen & van den Berg (lift_settling.hpp) as volume of grains; the default
///   van_rijn     van Rijn's pick-up function
enum class PickUp { mastbergen, van_rijn };

/// Volume of grains that a bed loses to suspension per second and area [m/s], van Rijn 1984 (J. Hydraul. Eng. 110,
/// 1494-1502):
///   0.00033 d*^0.3 T^1.5 sqrt((rho_s/rho_w - 1) g d),   T = theta/theta_cr - 1,   0 for T <= 0
/// Shields numbers theta and theta_cr [-]; dimensionless diameter d* [-]; grain diameter d [m]; densities rho_s of the
/// grains and rho_w of the water [kg/m^3]; gravity g [m/s^2].
/// Limits: measured with sands of 0.13 to 1.5 mm at T up to 25. With theta_cr = 0.0695 it is the law of Mastbergen &
/// van den Berg with alpha = 0.018.
/// PVC of 3.5 mm, 1540 kg/m^3 (d* = 61.01), theta = 0.4, theta_cr = 0.05: 2.85658e-3 m/s.
template <class Real>
HOST_DEVICE inline Real van_rijn_pick_up(Real shields, Real critical_shields, Real dimensionless_diameter,
                                         Real diameter, Real grain_density, Real water_density, Real gravity) {
  using std::pow;
  using std::sqrt;
  const Real stage = shields / critical_shields - 1;
  if (!(stage > 0)) return 0;
  const Real scale = sqrt((grain_density / water_density - 1) * gravity * diameter);
  return Real(0.00033) * pow(dimensionless_diameter, Real(0.3)) * stage * sqrt(stage) * scale;
}

}  // namespace thalweg
