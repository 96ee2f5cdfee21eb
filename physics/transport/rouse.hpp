#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {

/// Concentration at the height z over the bed of a current of depth H, over that at the height a (Rouse 1937, Trans. ASCE
/// 102, 463-543):
///   c/c_a = [(H - z)/z  a/(H - a)]^P,   P = w_s/(kappa u*)
/// z, a, H [m]; friction velocity u* [m/s]; settling velocity w_s [m/s]. Below a: 1; at the surface and above: 0.
/// z = 0.05, a = 0.005, H = 0.1 m, u* = 0.044, w_s = 0.018 m/s (P = 0.99778): 0.052976.
template <class Real>
HOST_DEVICE inline Real rouse_share(Real z, Real a, Real depth, Real friction_velocity, Real settling_velocity) {
  using std::pow;
  if (!(z > a)) return 1;
  if (!(z < depth) || !(friction_velocity > 0)) return 0;
  const Real exponent = settling_velocity / (von_karman<Real> * friction_velocity);
  return pow((depth - z) / z * a / (depth - a), exponent);
}

}  // namespace thalweg
