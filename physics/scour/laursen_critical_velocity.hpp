#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Mean velocity [m/s] at which grains of a bed begin to move, Laursen 1963 as HEC-18 (5th edition, 2012, eq. 6.1)
/// has it:
///   V_c = 6.19 y^(1/6) d^(1/3)      quartz in water
/// y depth [m], d grain diameter [m]. It is Shields' number 0.039 with Manning's n = 0.041 d^(1/6) (Strickler):
/// V_c = sqrt(0.039 (s - 1)) / 0.041 y^(1/6) d^(1/3), so that 6.19 holds for the relative density s = 2.65 [-]; other
/// densities enter by sqrt((s - 1)/1.65), which is coded.
/// Limits: fully rough flow, grains of some tenths of a millimetre and more. y = 2 m, d = 1 mm: 0.6948 m/s.
HOST_DEVICE inline double laursen_critical_velocity(double depth, double grain_diameter, double relative_density) {
  const double quartz = 6.19 * std::pow(depth, 1.0 / 6) * std::cbrt(grain_diameter);
  return quartz * std::sqrt((relative_density - 1) / 1.65);
}

}  // namespace thalweg
