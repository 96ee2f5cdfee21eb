#pragma once

#include <algorithm>
#include <cmath>

#include "physics/bed/grain_columns.hpp"

namespace thalweg {

/// Slides the grains of a bed whose slope is more than tan_repose, one sweep after the other (avalanche()).
class AvalancheSweep {
 public:
  AvalancheSweep(GrainColumns& bed, double tan_repose) : bed_(bed), tan_(tan_repose) {}

  /// One sweep, forth or back. True if nothing slid.
  bool run(bool forth) {
    at_rest_ = true;
    const int columns = bed_.grid.columns();
    for (int n = 0; n < columns; ++n) {
      const int column = forth ? n : columns - 1 - n;
      if (!(bed_.area[at(column)] > 0)) continue;
      for (const int axis : {0, 1}) slide_to_neighbour(column, axis);
      slide_in_four(column);
    }
    return at_rest_;
  }

 private:
  static constexpr double rounding = 1e-6;  // of the tangent: less than that is at rest
  static std::size_t at(int column) { return GrainColumns::at(column); }

  /// Between two neighbours the excess over the angle of repose moves down.
  void slide_to_neighbour(int column, int axis) {
    const int next = bed_.open_neighbour(column, axis, true);
    if (next < 0) return;
    const double spacing = bed_.grid.spacing(axis);
    const double difference = bed_.level(column) - bed_.level(next);
    const double excess = std::abs(difference) - tan_ * spacing;
    const int higher = difference > 0 ? column : next;
    const int lower = difference > 0 ? next : column;
    if (excess <= rounding * spacing || !(bed_.grains[at(higher)] > 0)) return;
    const double bulk = excess / (1 / bed_.area[at(higher)] + 1 / bed_.area[at(lower)]);
    const double moved = std::min({bed_.packing * bulk, bed_.grains[at(higher)], bed_.room(lower)});
    if (!(moved > 0)) return;
    bed_.grains[at(higher)] -= moved;
    bed_.grains[at(lower)] += moved;
    at_rest_ = false;
  }

  /// In a square of four columns the plane through them is made less steep.
  void slide_in_four(int column) {
    const int x = bed_.open_neighbour(column, 0, true);
    const int y = bed_.open_neighbour(column, 1, true);
    const int xy = x < 0 || y < 0 ? -1 : bed_.open_neighbour(x, 1, true);
    if (xy < 0) return;
    const int corners[4] = {column, x, y, xy};
    double z[4];
    double area = bed_.area[at(column)];
    for (int n = 0; n < 4; ++n) {
      z[n] = bed_.level(corners[n]);
      area = std::min(area, bed_.area[at(corners[n])]);
    }
    const double rise[2] = {0.5 * (z[1] - z[0] + z[3] - z[2]), 0.5 * (z[2] - z[0] + z[3] - z[1])};
    const double slope = std::hypot(rise[0] / bed_.grid.dx, rise[1] / bed_.grid.dy);
    if (!(slope > tan_ * (1 + rounding))) return;
    const double share = 1 - tan_ / slope;
    double gain[4];  // [m^3] of grains
    double part = 1;
    for (int n = 0; n < 4; ++n) {
      const double above = 0.5 * ((n % 2 == 1 ? rise[0] : -rise[0]) + (n / 2 == 1 ? rise[1] : -rise[1]));
      gain[n] = -share * above * area * bed_.packing;
      const double most = gain[n] < 0 ? bed_.grains[at(corners[n])] : bed_.room(corners[n]);
      if (std::abs(gain[n]) > most) part = std::min(part, most / std::abs(gain[n]));
    }
    if (!(part > 0)) return;
    for (int n = 0; n < 4; ++n) bed_.grains[at(corners[n])] += part * gain[n];
    at_rest_ = false;
  }

  GrainColumns& bed_;
  double tan_;
  bool at_rest_ = true;
};

/// Lets slopes slide that are steeper than tan_repose, the tangent of the angle of repose [-]: between neighbours along an
/// axis, and of the plane through each four columns, so that a heap becomes a cone and a hole a funnel, not pyramids.
/// Sweeps go on until no slope is too steep or they are used up; the rest slides in the next step. Grains are conserved
/// to rounding. Returns true if all slopes are at rest.
inline bool avalanche(GrainColumns& bed, double tan_repose, int most_sweeps = 50) {
  AvalancheSweep sweep(bed, tan_repose);
  for (int n = 0; n < most_sweeps; ++n) {
    if (sweep.run(n % 2 == 0)) return true;
  }
  return false;
}

}  // namespace thalweg
