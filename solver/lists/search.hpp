#pragma once

#include <algorithm>
#include <cstdint>

#include "solver/lists/cells.hpp"

// The search of one cluster for its neighbours.
namespace thalweg::neighbours {

/// Finds every particle within reach of any member of a cluster, each once.
template <int Dim, class Device>
struct ClusterSearch {
  CellTable<Dim> table;
  Lattice<Dim> lattice;
  const Record* records;
  Vec<Dim, const std::int32_t*> places;  // of all particles, one array a direction
  float reach2;

  /// True (a truth a lane) for particles within reach of a member in [from, to) but of none in [already, from).
  struct Within {
    const ClusterSearch& search;
    Index already, from, to;

    template <class I>
    HOST_DEVICE auto operator()(const Vec<Dim, I>& place) const {
      auto in_reach = near(place, from);
      for (Index m = from + 1; m < to; ++m) in_reach = lane_or(in_reach, near(place, m));
      for (Index m = already; m < from; ++m) in_reach = lane_and_not(in_reach, near(place, m));
      return in_reach;
    }

    template <class I>
    HOST_DEVICE auto near(const Vec<Dim, I>& place, Index m) const {
      auto d = along(place, m, 0);
      auto r2 = d * d;
      for (int k = 1; k < Dim; ++k) {
        d = along(place, m, k);
        r2 = r2 + d * d;
      }
      return r2 < decltype(r2)(search.reach2);
    }

    template <class I>
    HOST_DEVICE auto along(const Vec<Dim, I>& place, Index m, int k) const {
      const auto d = to_float(lane_difference(place[k], search.records[m].place[axis<Dim>(k)]));
      return d * decltype(d)(search.lattice.quantum[k]);
    }
  };

  /// The extent of some members, counted in 2^-32 of a list cell.
  struct Box {
    Vec<Dim, std::int64_t> low{};
    Vec<Dim, std::int64_t> high{};
  };

  /// Square of the distance along k from a box to a list cell [m^2].
  HOST_DEVICE float squared_gap(const Box& box, int k, std::int64_t cell) const {
    const std::int64_t below = box.low[k] - ((cell + 1) << 32);
    const std::int64_t above = (cell << 32) - box.high[k];
    const auto gap = static_cast<float>(std::max<std::int64_t>(0, std::max(below, above)));
    const float d = gap * lattice.quantum[k] / static_cast<float>(lattice.cells[k]);
    return d * d;
  }

  /// range(begin, end) for the particles of every occupied cell in reach of a box; walls only with sections = 2.
  template <class Range>
  HOST_DEVICE void each_range(const Box& box, int sections, const Range& range) const {
    constexpr float rounding = 1.0001F;  // of the gaps
    Vec<Dim, std::int64_t> first{};
    Vec<Dim, std::int64_t> last{};
    bool once_around[Dim];
    for (int k = 0; k < Dim; ++k) {
      first[k] = (box.low[k] >> 32) - 1;
      last[k] = (box.high[k] >> 32) + 1;
      // Once around a short period and no further; the cells are then near both ways.
      once_around[k] = table.period[k] != 0 && last[k] - first[k] >= table.period[k];
      if (once_around[k]) last[k] = first[k] + table.period[k] - 1;
    }
    const auto gap = [&](int k, std::int64_t c) { return once_around[k] ? 0 : squared_gap(box, k, c); };
    Vec<Dim, float> gap2{};
    for (int k = 0; k < Dim; ++k) gap2[k] = gap(k, first[k]);
    Vec<Dim, std::int64_t> cell = first;
    while (true) {
      float distance2 = gap2[0];
      for (int k = 1; k < Dim; ++k) distance2 += gap2[k];
      const std::int64_t n = distance2 < rounding * reach2 ? table.number(cell) : -1;
      for (int s = 0; n >= 0 && s < sections; ++s) range(table.begin[s][n], table.end[s][n]);
      int k = 0;
      for (; k < Dim && ++cell[k] > last[k]; ++k) {
        cell[k] = first[k];
        gap2[k] = gap(k, cell[k]);
      }
      if (k == Dim) return;
      gap2[k] = gap(k, cell[k]);
    }
  }

  /// found(hits) for particles of the cells in reach of a box that lie within reach of a member in [from, to) but of
  /// none in [already, from).
  template <class Found>
  HOST_DEVICE void visit(const Box& box, Index already, Index from, Index to, int sections, const Found& found) const {
    const Within within{*this, already, from, to};
    each_range(box, sections,
               [&](Index begin, Index end) { Device::template filter<Dim>(places, begin, end, within, found); });
  }

  HOST_DEVICE Box box_of(Index first, Index last) const {
    Box box{};
    for (Index m = first; m < last; ++m) {
      for (int k = 0; k < Dim; ++k) {
        const auto at = static_cast<std::int64_t>(
            std::uint64_t{static_cast<std::uint32_t>(records[m].place[axis<Dim>(k)])} * lattice.cells[k]);
        box.low[k] = m == first ? at : std::min(box.low[k], at);
        box.high[k] = m == first ? at : std::max(box.high[k], at);
      }
    }
    return box;
  }

  /// True if a box is at most two cells wide.
  HOST_DEVICE static bool is_compact(const Box& box) {
    bool compact = true;
    for (int k = 0; k < Dim; ++k) compact = compact && (box.high[k] >> 32) - (box.low[k] >> 32) <= 1;
    return compact;
  }

  /// found(hits) for the neighbours of cluster members [first, last); walls need only fluid neighbours (sections = 1).
  template <class Found>
  HOST_DEVICE void search(Index first, Index last, int sections, const Found& found) const {
    const Box box = box_of(first, last);
    if (is_compact(box)) {
      visit(box, first, first, last, sections, found);
      return;
    }
    // Four in a row that lie far apart (isolated grains, the edge of the domain): around each by itself.
    for (Index m = first; m < last; ++m) visit(box_of(m, m + 1), first, m, m + 1, sections, found);
  }
};

}  // namespace thalweg::neighbours
