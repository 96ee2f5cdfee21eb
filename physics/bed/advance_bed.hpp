#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/bed/adapt_bed_load.hpp"
#include "physics/bed/avalanche.hpp"
#include "physics/bed/grains.hpp"
#include "physics/bed/move_bed_load.hpp"

namespace thalweg {

/// Outcome of advance_bed().
struct BedAdvance {
  double time = 0;            // [s] by which the bed went on
  double largest_change = 0;  // [m] of a level
};

/// Moves a bed by bed load and avalanches under stresses that stay as they are, one a column, for `duration` [s] or until
/// a level has changed by `most_change` [m] (Exner: (1 - n) dz/dt = -div q + settling). `settling` [m^3/s]: grains that
/// settle on each column, less those that rise; empty: none.
///
/// The step is such that no level changes by more than a fiftieth of a column's width, and that what a slope does to the
/// bed load, a diffusion with at most D = 3 q/(1 - n), is stable: D dt/dx^2 <= 1/8. Grains are conserved to rounding.
inline BedAdvance advance_bed(GrainColumns& bed, const Grains& of, const std::vector<BedStress>& stress,
                              const std::vector<double>& settling, double duration, double most_change) {
  const auto columns = static_cast<std::size_t>(bed.grid.columns());
  const double width = bed.grid.ny > 1 ? std::min(bed.grid.dx, bed.grid.dy) : bed.grid.dx;
  std::vector<double> start(columns);
  for (std::size_t c = 0; c < columns; ++c) start[c] = bed.level(static_cast<int>(c));
  const auto sent = [&](int column, int axis, bool forward) {
    return bed_load_between(bed, of, stress[GrainColumns::at(column)], column, axis, forward);
  };
  BedAdvance done;
  while (done.time < duration && done.largest_change < most_change) {
    std::vector<BedPassage> passages = find_passages(bed, sent);
    if (of.adaptation == BedLoadAdaptation::saltation) adapt_bed_load(bed, of, stress, passages);
    std::vector<double> rate(columns, 0.0);  // [m^3/s] of grains
    for (std::size_t c = 0; c < settling.size(); ++c) rate[c] = settling_on(bed, settling, static_cast<int>(c));
    double largest_sent = 0;  // [m^3/s]
    for (const BedPassage& passage : passages) {
      rate[GrainColumns::at(passage.from)] -= passage.rate;
      if (passage.to >= 0) rate[GrainColumns::at(passage.to)] += passage.rate;
      largest_sent = std::max(largest_sent, passage.rate);
    }
    double fastest = 0;  // [m/s]
    for (std::size_t c = 0; c < columns; ++c) {
      if (bed.area[c] > 0) fastest = std::max(fastest, std::abs(rate[c]) / (bed.packing * bed.area[c]));
    }
    double dt = duration - done.time;
    const double left = most_change - done.largest_change;
    if (fastest > 0) dt = std::min({dt, width / 50 / fastest, (left + most_change / 50) / fastest});
    const double across = bed.grid.ny > 1 ? width : bed.grid.dy;
    if (largest_sent > 0) dt = std::min(dt, width * width * bed.packing / (8 * 3 * largest_sent / across));
    settle_grains(bed, settling, dt);
    move_grains(bed, passages, dt);
    avalanche(bed, of.tan_friction);
    done.time += dt;
    for (std::size_t c = 0; c < columns; ++c) {
      if (bed.area[c] <= 0) continue;
      done.largest_change = std::max(done.largest_change, std::abs(bed.level(static_cast<int>(c)) - start[c]));
    }
  }
  return done;
}

}  // namespace thalweg
