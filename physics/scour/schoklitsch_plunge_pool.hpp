#pragma once

#include <cmath>

namespace thalweg {

/// Inputs of schoklitsch_depth().
struct SchoklitschPlungePool {
  double discharge = 0;  // q [m^2/s], per width of the falling water
  double drop = 0;       // H [m], from the water level above to the tailwater's
  double grain_90 = 0;   // d90 [m]
};

/// Depth of the deepest point of the pool below a fall [m], counted from the tailwater's surface:
///   y = 4.75 H^0.2 q^0.57/d90^0.32,   d90 in mm
/// The scour depth is y less the tailwater's depth. Source: Schoklitsch 1932 (Der Bauingenieur 13(41), 537-543), as
/// in Whittaker & Schleiss 1984 (VAW Mitteilungen 73, ETH Zurich). The author gives no range: sills and low weirs
/// over gravel. q = 1 m^2/s, H = 2 m, d90 = 20 mm: 2.092 m.
inline double schoklitsch_depth(const SchoklitschPlungePool& fall) {
  return 4.75 * std::pow(fall.drop, 0.2) * std::pow(fall.discharge, 0.57) / std::pow(1e3 * fall.grain_90, 0.32);
}

}  // namespace thalweg
