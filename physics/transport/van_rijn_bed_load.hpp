#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

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
