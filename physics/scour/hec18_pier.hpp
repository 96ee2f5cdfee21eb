#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Shape of a pier's upstream end.
enum class PierNose { circular, round, square, sharp };

/// Inputs of hec18_pier_scour().
struct Hec18Pier {
  double width = 0;         // a [m], of the pier across its own axis
  double length = 0;        // L [m] along its axis; counts where the flow comes at an angle
  double depth = 0;         // y1 [m], of the flow upstream of the pier
  double velocity = 0;      // V1 [m/s], mean over the depth there
  double angle = 0;         // theta [rad] between flow and pier
  double gravity = 9.81;    // g [m/s^2]
  double bed_factor = 1.1;  // K3 [-]
  PierNose nose = PierNose::circular;
};

/// K1 [-] of HEC-18: 1.1 square, 1.0 round or circular, 0.9 sharp; 1 for all above 5 degrees of attack.
inline double hec18_nose_factor(PierNose nose, double angle) {
  constexpr double five_degrees = 0.0872664625997164788;
  if (angle > five_degrees) return 1;
  switch (nose) {
    case PierNose::square:
      return 1.1;
    case PierNose::sharp:
      return 0.9;
    case PierNose::circular:
    case PierNose::round:
      return 1;
  }
  return 1;
}

/// K2 = (cos theta + (L/a) sin theta)^0.65 [-], L/a taken as at most 12; 1 for a circular pier, which has no angle.
inline double hec18_angle_factor(const Hec18Pier& pier) {
  if (pier.nose == PierNose::circular) return 1;
  const double slenderness = std::min(pier.length / pier.width, 12.0);
  return std::pow(std::cos(pier.angle) + slenderness * std::sin(pier.angle), 0.65);
}

/// Depth of the scour hole at a pier [m] below the bed around it, for clear water and live bed:
///   y_s/y1 = 2.0 K1 K2 K3 (a/y1)^0.65 Fr1^0.43,   Fr1 = V1/sqrt(g y1)
/// K3: 1.1 clear water, plane bed, small dunes; 1.1 to 1.2 dunes of 3 to 9 m; 1.3 above. A design formula: an
/// envelope of measurements, not their mean.
/// Source: Colorado State University equation, Richardson & Davis; HEC-18, FHWA-HIF-12-003, 5th edition 2012, eq.
/// 7.1. The 5th edition has no factor K4 for armouring any more, and neither has this.
/// a = 1.22 m, y1 = 3.12 m, V1 = 3.36 m/s, round nose: 3.01 m.
inline double hec18_pier_equation(const Hec18Pier& pier) {
  const double froude = pier.velocity / std::sqrt(pier.gravity * pier.depth);
  const double factors = hec18_nose_factor(pier.nose, pier.angle) * hec18_angle_factor(pier) * pier.bed_factor;
  return 2 * factors * pier.depth * std::pow(pier.width / pier.depth, 0.65) * std::pow(froude, 0.43);
}

/// The same, at most 2.4 a for Fr1 <= 0.8 and 3.0 a above at round noses in line with the flow: HEC-18's rule of
/// thumb, as HEC-RAS applies it. The example above: 2.93 m.
inline double hec18_pier_scour(const Hec18Pier& pier) {
  const bool round = pier.nose == PierNose::circular || (pier.nose == PierNose::round && pier.angle == 0);
  if (!round) return hec18_pier_equation(pier);
  const double froude = pier.velocity / std::sqrt(pier.gravity * pier.depth);
  return std::min(hec18_pier_equation(pier), (froude <= 0.8 ? 2.4 : 3.0) * pier.width);
}

/// Limits left: y1/a >= 0.8 (a wide pier in shallow water, for which HEC-18 overpredicts); L/a <= 12 at an angle.
inline std::vector<LimitLeft> limits_left(const Hec18Pier& pier) {
  Limits limits;
  limits.at_least("y/a", pier.depth / pier.width, 0.8);
  if (pier.angle > 0 && pier.nose != PierNose::circular) limits.at_most("L/a", pier.length / pier.width, 12);
  return limits.left();
}

}  // namespace thalweg
