#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/bed/grains.hpp"
#include "physics/bed/move_bed_load.hpp"
#include "physics/transport/saltation_length.hpp"

namespace thalweg {

/// The part of the law's rate that each column sends [-], where the bed load q comes to that rate over a length L:
///   div q = (q_law - q)/L
/// `passages` are the law's; length(column) gives L [m], path(column) the way of the flow through the column [m]. A column
/// passes on exp(-path/L) of what comes in, and adds the rest of the law's rate: exact along a uniform bed at any width of
/// the columns. With L = 0 it sends the law's rate. Columns at a fed end send it too. Where the law is 0 all grains stay.
template <class Length, class Path>
std::vector<double> share_of_law(const GrainColumns& bed, const std::vector<BedPassage>& passages, const Length& length,
                                 const Path& path) {
  const std::size_t columns = bed.grains.size();
  std::vector<double> law(columns, 0.0);                    // [m^3/s] that the law lets each column send
  std::vector<std::vector<const BedPassage*>> to(columns);  // passages that end at each
  for (const BedPassage& passage : passages) {
    law[GrainColumns::at(passage.from)] += passage.rate;
    if (passage.to >= 0) to[GrainColumns::at(passage.to)].push_back(&passage);
  }
  std::vector<double> kept(columns, 0.0);  // exp(-path/L)
  for (std::size_t c = 0; c < columns; ++c) {
    const int column = static_cast<int>(c);
    const double over = length(column);
    if (law[c] > 0 && over > 0 && bed.end_at(column) != BedEnd::fed) kept[c] = std::exp(-path(column) / over);
  }
  std::vector<double> share(columns, 1.0);
  const auto renew = [&](std::size_t c) {
    if (!(kept[c] > 0)) return 0.0;
    double coming = 0;
    for (const BedPassage* passage : to[c]) coming += share[GrainColumns::at(passage->from)] * passage->rate;
    const double before = share[c];
    share[c] = kept[c] * coming / law[c] + (1 - kept[c]);
    return std::abs(share[c] - before) * law[c];
  };
  const double largest = columns > 0 ? *std::max_element(law.begin(), law.end()) : 0;
  // Sweeps forth and back carry the grains along the flow; only eddies take more than two.
  const int most_sweeps = 500;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0;
    for (std::size_t c = 0; c < columns; ++c) change = std::max(change, renew(c));
    for (std::size_t c = columns; c-- > 0;) change = std::max(change, renew(c));
    if (!(change > 1e-12 * largest)) break;
  }
  return share;
}

/// Makes the law's passages those of a bed load that comes to the law's rate over the length of its grains' jumps.
inline void adapt_bed_load(const GrainColumns& bed, const Grains& of, const std::vector<BedStress>& stress,
                           std::vector<BedPassage>& passages) {
  const double size_number = of.size_number();
  const auto jump = [&](int column) {
    const BedStress& on = stress[GrainColumns::at(column)];
    return on.shields > 0 ? saltation_length(on.shields, on.flat_critical, size_number, of.diameter) : 0;
  };
  const auto path = [&](int column) {
    const BedStress& on = stress[GrainColumns::at(column)];
    return bed.grid.dx / (std::abs(on.along_x) + std::abs(on.along_y));
  };
  const std::vector<double> share = share_of_law(bed, passages, jump, path);
  for (BedPassage& passage : passages) passage.rate *= share[GrainColumns::at(passage.from)];
}

}  // namespace thalweg
