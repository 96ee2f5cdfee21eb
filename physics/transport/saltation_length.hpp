#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// The way in which bed load comes to the law's rate where the stress of the water changes.
///   none        it has the law's rate everywhere
///   saltation   within the length of a grain's jump
enum class BedLoadAdaptation { none, saltation };

/// Length [m] of the jumps of grains in bed load, van Rijn 1984 (J. Hydraul. Eng. 110, 1431-1456):
///   3 d d*^0.6 T^0.9,   T = theta/theta_cr - 1,   0 for T <= 0
/// d diameter [m], T transport stage [-], d* dimensionless diameter [-] (lift_settling.hpp). Limits: d of 0.2 to 2 mm.
/// d = 0.8 mm, d* = 20.24, theta = 0.3, theta_cr = 0.03 (T = 9): 0.105379 m.
template <class Real>
HOST_DEVICE inline Real saltation_length(Real shields, Real critical_shields, Real dimensionless_diameter,
                                         Real diameter) {
  using std::pow;
  const Real stage = shields / critical_shields - 1;
  if (!(stage > 0)) return 0;
  return 3 * diameter * pow(dimensionless_diameter, Real(0.6)) * pow(stage, Real(0.9));
}

}  // namespace thalweg
