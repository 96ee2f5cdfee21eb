#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of laursen_clear_water_depth().
struct LaursenClearWater {
  double discharge = 0;          // q2 [m^2/s], per width of the contraction: Q/W2
  double grain_diameter = 0;     // D50 [m]
  double relative_density = 0;   // s [-], for its limit alone
  double velocity = 0;           // V1 [m/s], upstream, for its limit alone
  double critical_velocity = 0;  // V_c [m/s], upstream (laursen_critical_velocity.hpp), for its limit alone
};

/// Depth of the flow in a long contraction after scour, y2 [m], where the flow brings no grains:
///   y2 = [0.025 q2^2/D_m^(2/3)]^(3/7),   D_m = 1.25 D50
/// The depth at which the bed just does not move; 0.025 in SI units, for quartz. The scour depth is y2 less the
/// depth that the contraction had before. Source: Laursen 1963 (J. Hydraul. Div. ASCE 89(3), 93-118) in the form of
/// HEC-18, 5th edition 2012, eq. 6.4. Q = 10 m^3/s, W2 = 8 m, D50 = 5 mm: 1.063 m, 0.263 m below a depth of 0.8 m.
inline double laursen_clear_water_depth(const LaursenClearWater& flow) {
  const double D_m = 1.25 * flow.grain_diameter;
  return std::pow(0.025 * flow.discharge * flow.discharge / std::pow(D_m, 2.0 / 3), 3.0 / 7);
}

/// Limits left: V1/V_c <= 1, above which the flow brings grains; s from 2.55 to 2.75, the quartz of the coefficient.
inline std::vector<LimitLeft> limits_left(const LaursenClearWater& flow) {
  return Limits()
      .at_most("V/Vc", flow.velocity / flow.critical_velocity, 1)
      .between("s", flow.relative_density, 2.55, 2.75)
      .left();
}

}  // namespace thalweg
