#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Bed load over its unit [-], Wong & Parker 2006 (J. Hydraul. Eng. 132, 1159-1168), who fitted the flumes of
/// Meyer-Peter & Mueller again without a correction for the bed's form:
///   3.97 (theta - theta_cr)^1.5,   0 for theta <= theta_cr
/// Limits: gravels on a flat bed, fitted with theta_cr = 0.0495 and theta up to about 0.25.
/// theta = 0.4, theta_cr = 0.0495: 0.823802.
template <class Real>
HOST_DEVICE inline Real wong_parker(Real shields, Real critical_shields) {
  using std::sqrt;
  const Real excess = shields - critical_shields;
  return excess > 0 ? Real(3.97) * excess * sqrt(excess) : Real(0);
}

}  // namespace thalweg
