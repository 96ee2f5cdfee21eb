#pragma once

#include <cstdint>

#include "solver/lists/cell_reach.hpp"

// The search of one cluster for its neighbours, on a device that filters places in packs.
namespace thalweg::neighbours {

/// Finds every particle within reach of any member of a cluster, each once.
template <int Dim, class Device>
struct ClusterSearch : CellReach<Dim> {
  const Record* records;
  Vec<Dim, const std::int32_t*> places;  // of all particles, one array a direction

  /// True (a truth a lane) for particles within reach of a member in [from, to) but of none in [already, from).
  struct Within {
    const ClusterSearch& search;
    Index already, from, to;

    template <class I>
    auto operator()(const Vec<Dim, I>& place) const {
      auto in_reach = near(place, from);
      for (Index m = from + 1; m < to; ++m) in_reach = lane_or(in_reach, near(place, m));
      for (Index m = already; m < from; ++m) in_reach = lane_and_not(in_reach, near(place, m));
      return in_reach;
    }

    template <class I>
    auto near(const Vec<Dim, I>& place, Index m) const {
      auto d = along(place, m, 0);
      auto r2 = d * d;
      for (int k = 1; k < Dim; ++k) {
        d = along(place, m, k);
        r2 = r2 + d * d;
      }
      return r2 < decltype(r2)(search.reach2);
    }

    template <class I>
    auto along(const Vec<Dim, I>& place, Index m, int k) const {
      const auto d = to_float(lane_difference(place[k], search.place_of(m, k)));
      return d * decltype(d)(search.lattice.quantum[k]);
    }
  };

  [[nodiscard]] std::int32_t place_of(Index i, int k) const { return records[i].place[axis<Dim>(k)]; }

  /// range(begin, end) for the particles of every occupied cell in reach of some; with sections = 1 fluid, with 2 walls too.
  template <class Range>
  void each_range(const CellExtent<Dim>& extent, int sections, const Range& range) const {
    const CellWindow<Dim> window = this->window_around(extent);
    const auto gap = [&](int k, std::int64_t c) { return this->squared_gap(extent, window, k, c); };
    Vec<Dim, float> gap2{};
    for (int k = 0; k < Dim; ++k) gap2[k] = gap(k, window.first[k]);
    Vec<Dim, std::int64_t> cell = window.first;
    while (true) {
      float distance2 = gap2[0];
      for (int k = 1; k < Dim; ++k) distance2 += gap2[k];
      const std::int64_t n = distance2 < this->rounding * this->reach2 ? this->table.number(cell) : -1;
      const int last = sections * this->table.sections / 2;
      for (int s = 0; n >= 0 && s < last; ++s) range(this->table.begin[s][n], this->table.end[s][n]);
      int k = 0;
      for (; k < Dim && ++cell[k] > window.last[k]; ++k) {
        cell[k] = window.first[k];
        gap2[k] = gap(k, cell[k]);
      }
      if (k == Dim) return;
      gap2[k] = gap(k, cell[k]);
    }
  }

  /// found(hits) for particles of the cells in reach of an extent that lie within reach of a member in [from, to) but of
  /// none in [already, from).
  template <class Found>
  void visit(const CellExtent<Dim>& extent, Index already, Index from, Index to, int sections,
             const Found& found) const {
    const Within within{*this, already, from, to};
    each_range(extent, sections,
               [&](Index begin, Index end) { Device::template filter<Dim>(places, begin, end, within, found); });
  }

  CellExtent<Dim> extent_of_members(Index first, Index last) const {
    return this->extent_of(last - first, [&](Index m, int k) { return place_of(first + m, k); });
  }

  /// found(hits) for the neighbours of cluster members [first, last); walls need only fluid neighbours (sections = 1).
  template <class Found>
  void search(Index first, Index last, int sections, const Found& found) const {
    const CellExtent<Dim> extent = extent_of_members(first, last);
    if (extent.is_compact()) {
      visit(extent, first, first, last, sections, found);
      return;
    }
    // Four in a row that lie far apart (isolated grains, the edge of the domain): around each by itself.
    for (Index m = first; m < last; ++m) visit(extent_of_members(m, m + 1), first, m, m + 1, sections, found);
  }
};

}  // namespace thalweg::neighbours
