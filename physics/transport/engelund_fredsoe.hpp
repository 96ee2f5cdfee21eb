#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Bed load over its unit [-], Engelund & Fredsoe 1976 (Nordic Hydrology 7, 293-306):
///   5 p (sqrt(theta) - 0.7 sqrt(theta_cr)),   0 for theta <= theta_cr
///   p = [1 + ((pi/6) beta/(theta - theta_cr))^4]^(-1/4)   share of the surface grains that move
/// The speed of those grains is that of the roots, beta the tangent of their dynamic friction angle: 0.51, of 27 deg.
/// Limits: sands; p is at most 1, so that far above the threshold one layer of grains moves.
/// theta = 0.4, theta_cr = 0.05: 2.212234.
template <class Real>
HOST_DEVICE inline Real engelund_fredsoe(Real shields, Real critical_shields, Real dynamic_friction = Real(0.51)) {
  using std::sqrt;
  const Real excess = shields - critical_shields;
  if (!(excess > 0)) return 0;
  const Real sixth_of_pi = Real(0.52359877559829887);
  const Real held = sixth_of_pi * dynamic_friction / excess;
  const Real held2 = held * held;
  const Real moving = 1 / sqrt(sqrt(1 + held2 * held2));
  return 5 * moving * (sqrt(shields) - Real(0.7) * sqrt(critical_shields));
}

}  // namespace thalweg
