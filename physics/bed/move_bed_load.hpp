#pragma once

#include <algorithm>
#include <vector>

#include "physics/bed/grain_columns.hpp"

namespace thalweg {

/// Grains on their way between two columns.
struct BedPassage {
  int from;
  int to;       // -1: out of the bed, at an open end
  double rate;  // [m^3/s] of grains, > 0
};

/// The passages of a bed load. sent(column, axis, forward) is the bed load [m^2/s], volume of grains per metre of width,
/// that a column sends to its neighbour along an axis, or out at an open end; >= 0.
template <class Sent>
std::vector<BedPassage> find_passages(const GrainColumns& bed, const Sent& sent) {
  std::vector<BedPassage> passages;
  for (int column = 0; column < bed.grid.columns(); ++column) {
    if (bed.grains[GrainColumns::at(column)] <= 0) continue;
    for (const int axis : {0, 1}) {
      for (const bool forward : {false, true}) {
        const int to = bed.open_neighbour(column, axis, forward);
        if (to < 0 && bed.end_at(column) != open_end(axis, forward)) continue;
        const double width = axis == 0 ? bed.grid.dy : bed.grid.dx;
        const double rate = sent(column, axis, forward) * width;
        if (rate > 0) passages.push_back({column, to, rate});
      }
    }
  }
  return passages;
}

/// Moves grains for dt [s]. No column gives more than it has, none takes more than it has room for, and nothing crosses
/// closed ends. Columns at a fed end keep what they have. Grains in the bed, less those fed, plus those that left, are
/// conserved to rounding.
inline void move_grains(GrainColumns& bed, const std::vector<BedPassage>& passages, double dt) {
  const auto at = [](int column) { return GrainColumns::at(column); };
  std::vector<double> leaving(bed.grains.size(), 0.0);
  std::vector<double> coming(bed.grains.size(), 0.0);
  for (const BedPassage& passage : passages) {
    leaving[at(passage.from)] += passage.rate * dt;
    if (passage.to >= 0) coming[at(passage.to)] += passage.rate * dt;
  }
  const std::vector<double> held = bed.grains;
  for (const BedPassage& passage : passages) {
    double share = std::min(1.0, held[at(passage.from)] / leaving[at(passage.from)]);
    if (passage.to >= 0) share = std::min(share, bed.room(passage.to) / coming[at(passage.to)]);
    const double moved = share * passage.rate * dt;
    bed.grains[at(passage.from)] -= moved;
    (passage.to >= 0 ? bed.grains[at(passage.to)] : bed.left) += moved;
  }
  for (std::size_t column = 0; column < bed.end.size(); ++column) {
    if (bed.end[column] != BedEnd::fed) continue;
    bed.fed += held[column] - bed.grains[column];
    bed.grains[column] = held[column];
  }
}

/// Grains [m^3/s] that settle on a column out of the water, or rise from it if negative: `settling` but for columns that
/// keep what they have at a fed end, are solid, have no grains to give or no room for more.
inline double settling_on(const GrainColumns& bed, const std::vector<double>& settling, int column) {
  const std::size_t c = GrainColumns::at(column);
  if (settling.empty() || !(bed.area[c] > 0) || bed.end_at(column) == BedEnd::fed) return 0;
  const bool can = settling[c] < 0 ? bed.grains[c] > 0 : bed.room(column) > 0;
  return can ? settling[c] : 0;
}

/// Lets grains settle and rise for dt [s]. No column gives more than it has, nor takes more than it has room for. What a
/// column at a fed end exchanges is made up for by its feed.
inline void settle_grains(GrainColumns& bed, const std::vector<double>& settling, double dt) {
  for (std::size_t c = 0; c < settling.size(); ++c) {
    const int column = static_cast<int>(c);
    const double asked = settling_on(bed, settling, column) * dt;
    const double gain = std::max(-bed.grains[c], std::min(asked, bed.room(column)));
    bed.grains[c] += gain;
    bed.lifted -= gain;
    if (bed.area[c] > 0 && bed.end_at(column) == BedEnd::fed) {
      bed.lifted -= settling[c] * dt;
      bed.fed -= settling[c] * dt;
    }
  }
}

/// Moves grains by the bed load for dt [s].
template <class Sent>
void move_bed_load(GrainColumns& bed, const Sent& sent, double dt) {
  move_grains(bed, find_passages(bed, sent), dt);
}

}  // namespace thalweg
