#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

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

}  // namespace thalweg
