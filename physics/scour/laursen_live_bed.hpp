#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of laursen_live_bed_depth().
struct LaursenLiveBed {
  double depth = 0;              // y1 [m], upstream
  double width = 0;              // W1 [m], of the bed upstream
  double contracted_width = 0;   // W2 [m], of the bed in the contraction
  double flow_ratio = 1;         // Q2/Q1 [-]: discharge in the contraction over that above the moving bed upstream
  double friction_velocity = 0;  // u* [m/s], upstream
  double settling_velocity = 0;  // w [m/s], of the median grain
  double velocity = 0;           // V1 [m/s], upstream, for its limit alone
  double critical_velocity = 0;  // V_c [m/s], upstream (laursen_critical_velocity.hpp), for its limit alone
};

/// Exponent k1 [-] of the widths by u*/w: 0.59 below 0.5 (bed load), 0.69 above 2 (suspended load), else 0.64.
inline double laursen_width_exponent(double friction_velocity, double settling_velocity) {
  const double ratio = friction_velocity / settling_velocity;
  if (ratio < 0.5) return 0.59;
  return ratio > 2 ? 0.69 : 0.64;
}

/// Depth of the flow in a long contraction after scour, y2 [m], where the flow brings grains:
///   y2/y1 = (Q2/Q1)^(6/7) (W1/W2)^k1
/// The scour depth is y2 less the depth that the contraction had before. Source: Laursen 1960 (J. Hydraul. Div. ASCE
/// 86(2), 39-54), without the ratio of roughnesses as in HEC-18, 5th edition 2012, eq. 6.2.
/// y1 = 2 m, W1/W2 = 2, Q2 = Q1, u*/w = 1: 3.1167 m.
inline double laursen_live_bed_depth(const LaursenLiveBed& flow) {
  const double k1 = laursen_width_exponent(flow.friction_velocity, flow.settling_velocity);
  return flow.depth * std::pow(flow.flow_ratio, 6.0 / 7) * std::pow(flow.width / flow.contracted_width, k1);
}

/// Limits left: V1/V_c >= 1, below which no grains come; W2/W1 <= 1.
inline std::vector<LimitLeft> limits_left(const LaursenLiveBed& flow) {
  return Limits()
      .at_least("V/Vc", flow.velocity / flow.critical_velocity, 1)
      .at_most("W2/W1", flow.contracted_width / flow.width, 1)
      .left();
}

}  // namespace thalweg
