#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of dey_sarkar_scour().
struct DeySarkarWallJet {
  double velocity = 0;          // U0 [m/s], of the jet
  double opening = 0;           // b [m], height of the opening
  double apron = 0;             // l [m], length of the rigid apron between opening and bed
  double tailwater = 0;         // h [m], depth of the water over the apron's level
  double grain_diameter = 0;    // d50 [m]
  double relative_density = 0;  // s [-]
  double gravity = 9.81;        // g [m/s^2]
};

/// Densimetric Froude number F0 = U0/sqrt((s - 1) g d50) [-] of a jet over a bed.
inline double densimetric_froude(const DeySarkarWallJet& jet) {
  return jet.velocity / std::sqrt((jet.relative_density - 1) * jet.gravity * jet.grain_diameter);
}

/// Depth [m] that follows a jet of an opening in a hydraulic jump (Belanger): b/2 (sqrt(1 + 8 U0^2/(g b)) - 1). A
/// jet is submerged where the tailwater is deeper.
inline double sequent_depth(double opening, double velocity, double gravity) {
  return 0.5 * opening * (std::sqrt(1 + 8 * velocity * velocity / (gravity * opening)) - 1);
}

/// Depth of the equilibrium scour hole [m] below an apron under a submerged horizontal jet, below the apron's level:
///   d_s/b = 2.59 F0^0.94 (l/b)^-0.37 (h/b)^0.16 (d50/b)^0.25
/// Source: Dey & Sarkar 2006, J. Hydraul. Eng. 132(3), 246-257.
/// U0 = 1.21 m/s, b = 15 mm, l = 0.4 m, h = 0.163 m, d50 = 0.8 mm, s = 2.65: 0.0749 m.
inline double dey_sarkar_scour(const DeySarkarWallJet& jet) {
  const double b = jet.opening;
  return 2.59 * b * std::pow(densimetric_froude(jet), 0.94) * std::pow(jet.apron / b, -0.37) *
         std::pow(jet.tailwater / b, 0.16) * std::pow(jet.grain_diameter / b, 0.25);
}

/// Limits left: d50 from 0.26 mm to 3.1 mm; h over the sequent depth >= 1 (a submerged jet); an apron at least as
/// long as the opening is high, because the formula grows without bound as it becomes short.
inline std::vector<LimitLeft> limits_left(const DeySarkarWallJet& jet) {
  return Limits()
      .between("d50 [mm]", 1e3 * jet.grain_diameter, 0.26, 3.1)
      .at_least("h/sequent depth", jet.tailwater / sequent_depth(jet.opening, jet.velocity, jet.gravity), 1)
      .at_least("l/b", jet.apron / jet.opening, 1)
      .left();
}

}  // namespace thalweg
