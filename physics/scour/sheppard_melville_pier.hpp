#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/scour/hec18_pier.hpp"
#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of sheppard_melville_pier_scour().
struct SheppardMelvillePier {
  double effective_width = 0;    // a* [m], effective_pier_width()
  double depth = 0;              // y1 [m], of the flow upstream of the pier
  double velocity = 0;           // V1 [m/s], mean over the depth there
  double critical_velocity = 0;  // V_c [m/s], of the bed in that depth (sheppard_critical_velocity.hpp)
  double grain_diameter = 0;     // D50 [m]
  double gravity = 9.81;         // g [m/s^2]
};

/// Effective width a* [m] of a pier: its projection across the flow times a factor of its shape, 1 for a circular or
/// round one, 0.86 + 0.97 |theta - pi/4|^4 for a rectangular one, theta the angle of attack [rad] (sharp noses count
/// as rectangular).
inline double effective_pier_width(PierNose nose, double width, double length, double angle) {
  if (nose == PierNose::circular) return width;
  const double projected = width * std::cos(angle) + length * std::sin(angle);
  if (nose == PierNose::round) return projected;
  constexpr double eighth_turn = 0.78539816339744831;
  return projected * (0.86 + 0.97 * std::pow(std::abs(angle - eighth_turn), 4));
}

/// Depth of the equilibrium scour hole at a pier [m] below the bed around it (the S/M equation):
///   y_s/a* = 2.5 f1 f2 f3                                                          0.4 <= V1/V_c <= 1
///   y_s/a* = f1 [2.2 (V1 - V_c)/(V_lp - V_c) + 2.5 f3 (V_lp - V1)/(V_lp - V_c)]    V_c < V1 <= V_lp
///   y_s/a* = 2.2 f1                                                                V1 > V_lp
///   f1 = tanh[(y1/a*)^0.4],  f2 = 1 - 1.2 ln^2(V1/V_c),  f3 = r/(0.4 r^1.2 + 10.6 r^-0.13),  r = a*/D50
///   V_lp = max(5 V_c, 0.6 sqrt(g y1))      velocity of the live-bed peak
/// Below 0.4 V_c there is no scour: 0. f2 is 0 at 0.401 V_c and is not let below. The first two meet at V_c, the
/// last two at V_lp. Source: Sheppard, Melville & Demir 2014, J. Hydraul. Eng. 140(1), 14-23; HEC-18, 5th edition
/// 2012, section 7.3. a* = 1 m, y1 = 2 m, D50 = 0.5 mm, V1 = V_c: 1.1832 m.
inline double sheppard_melville_pier_scour(const SheppardMelvillePier& pier) {
  const double a = pier.effective_width;
  const double V = pier.velocity;
  const double V_c = pier.critical_velocity;
  if (V < 0.4 * V_c) return 0;
  const double r = a / pier.grain_diameter;
  const double f1 = std::tanh(std::pow(pier.depth / a, 0.4));
  const double f3 = r / (0.4 * std::pow(r, 1.2) + 10.6 * std::pow(r, -0.13));
  if (V <= V_c) {
    const double logarithm = std::log(V / V_c);
    const double f2 = std::max(0.0, 1 - 1.2 * logarithm * logarithm);
    return 2.5 * a * f1 * f2 * f3;
  }
  const double V_lp = std::max(5 * V_c, 0.6 * std::sqrt(pier.gravity * pier.depth));
  if (V > V_lp) return 2.2 * a * f1;
  return a * f1 * (2.2 * (V - V_c) + 2.5 * f3 * (V_lp - V)) / (V_lp - V_c);
}

/// Limits left: V1/V_c >= 0.4, below which no scour was seen.
inline std::vector<LimitLeft> limits_left(const SheppardMelvillePier& pier) {
  return Limits().at_least("V/Vc", pier.velocity / pier.critical_velocity, 0.4).left();
}

}  // namespace thalweg
