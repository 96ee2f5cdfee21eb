#pragma once

#include <bit>
#include <cstdint>

#include "solver/backend/members.hpp"
#include "solver/lists/cell_reach.hpp"
#include "solver/lists/cluster_marks.hpp"

// The search of one cluster for its neighbours by a team of a GPU's threads (backend/gpu.hpp). The team looks at 32
// candidates at a time, one a thread, and has the four members in registers: a candidate costs one load of 16 bytes. A
// first search counts the neighbours and keeps a bit for each candidate, so that the second, which writes them, does not
// look at the places again.
namespace thalweg::neighbours {

/// A place in one load.
struct alignas(16) PlaceQuad {
  std::int32_t c[4];
};

/// Words of 32 candidates that a cluster keeps; a search that needs more looks at the others twice. In 3-D a list reach
/// meets some 30 cells of 40 particles, hence some 60 words.
template <int Dim>
inline constexpr Index kept_words = Dim == 2 ? 24 : 72;

/// The number of bits of a word below bit `lane`.
HOST_DEVICE inline Index bits_below(std::uint32_t word, Index lane) {
  return static_cast<Index>(std::popcount(word & ((1U << lane) - 1)));
}

/// Finds every particle within reach of any member of a cluster, each once, in the order of ClusterSearch. Cells have so many
/// sections (CellTable).
template <int Dim, int in_cell>
struct TeamSearch : CellReach<Dim> {
  const PlaceQuad* places;  // of all particles

  /// Members of a cluster; a cluster with fewer than four repeats its last. Loops over them have a fixed length, so that
  /// they stay in registers.
  struct Members {
    Vec<Dim, std::int32_t> place[cluster_size];
    Index first;
    Index count;
  };

  HOST_DEVICE Vec<Dim, std::int32_t> place_of(Index i) const {
    const PlaceQuad quad = places[i];
    Vec<Dim, std::int32_t> place{};
    for (int k = 0; k < Dim; ++k) place[k] = quad.c[axis<Dim>(k)];
    return place;
  }

  /// Tests the candidates of a compact cluster: |x - m|^2 < reach^2 for some member m as |x|^2 < max(2 m.x + reach^2 -
  /// |m|^2), x and m relative to the frame's middle (ListScratch::choose).
  struct NearAny {
    Vec<Dim, std::int32_t> middle;
    Vec<Dim, float> quantum;
    Vec<Dim, float> twice[cluster_size];
    float bound[cluster_size];

    HOST_DEVICE Vec<Dim, float> relative(const Vec<Dim, std::int32_t>& place) const {
      Vec<Dim, float> x{};
      for (int k = 0; k < Dim; ++k) x[k] = to_float(lane_difference(place[k], middle[k])) * quantum[k];
      return x;
    }
    HOST_DEVICE bool operator()(const Vec<Dim, std::int32_t>& place) const {
      const Vec<Dim, float> x = relative(place);
      float most = -HUGE_VALF;
      for (Index m = 0; m < cluster_size; ++m) {
        float b = bound[m];
        for (int k = 0; k < Dim; ++k) b = b + twice[m][k] * x[k];
        most = b > most ? b : most;
      }
      return dot(x, x) < most;
    }
  };

  HOST_DEVICE NearAny near_any(const Members& of, const LocalFrame<Dim>& frame) const {
    NearAny near{};
    near.middle = frame.middle;
    near.quantum = this->lattice.quantum;
    for (Index m = 0; m < cluster_size; ++m) {
      const Vec<Dim, float> at = near.relative(of.place[m]);
      for (int k = 0; k < Dim; ++k) near.twice[m][k] = 2 * at[k];
      near.bound[m] = LocalFrame<Dim>::rounding * this->reach2 - dot(at, at);
    }
    return near;
  }

  /// Tests the candidates around member `of` alone; those of the members before it have been found.
  struct NearOne {
    const TeamSearch& search;
    const Members& members;
    Index of;

    HOST_DEVICE bool is_near(const Vec<Dim, std::int32_t>& place, Index m) const {
      float r2 = 0;
      for (int k = 0; k < Dim; ++k) {
        const float d = to_float(lane_difference(place[k], members.place[m][k])) * search.lattice.quantum[k];
        r2 = r2 + d * d;
      }
      return r2 < search.reach2;
    }
    HOST_DEVICE bool operator()(const Vec<Dim, std::int32_t>& place) const {
      bool near = false;
      bool found_before = false;
      for (Index m = 0; m < cluster_size; ++m) {
        const bool near_this = is_near(place, m);
        near = near || (m == of && near_this);
        found_before = found_before || (m < of && near_this);
      }
      return near && !found_before;
    }
  };

  /// Number in the table of the n-th cell of a window, or -1 where it is out of reach, empty for ever or outside.
  HOST_DEVICE std::int64_t cell_number(const CellExtent<Dim>& extent, const CellWindow<Dim>& window, Index n) const {
    Vec<Dim, std::int64_t> cell{};
    float distance2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const auto width = static_cast<Index>(window.last[k] - window.first[k] + 1);
      cell[k] = window.first[k] + n % width;
      n /= width;
      const float gap2 = this->squared_gap(extent, window, k, cell[k]);
      distance2 = k == 0 ? gap2 : distance2 + gap2;
    }
    return distance2 < this->rounding * this->reach2 ? this->table.number(cell) : -1;
  }

  /// found(first candidate, hits) for 32 candidates at a time of the cells in reach; hits(near) are the bits of those that
  /// pass a test.
  template <class Team, class Near, class Found>
  HOST_DEVICE void visit(Team& team, const CellExtent<Dim>& extent, int sections, const Near& near,
                         const Found& found) const {
    const CellWindow<Dim> window = this->window_around(extent);
    Index cells = 1;
    for (int k = 0; k < Dim; ++k) cells *= static_cast<Index>(window.last[k] - window.first[k] + 1);
    for (Index from = 0; from < cells; from += Team::size) {
      typename Team::template PerLane<Index> begin[in_cell];
      typename Team::template PerLane<Index> end[in_cell];
      team.each([&](Index lane) {
        const std::int64_t n = from + lane < cells ? cell_number(extent, window, from + lane) : -1;
        for (int s = 0; s < in_cell; ++s) {
          const bool visited = n >= 0 && s < sections * in_cell / 2;
          begin[s][lane] = visited ? this->table.begin[s][n] : 0;
          end[s][lane] = visited ? this->table.end[s][n] : 0;
        }
      });
      std::uint32_t occupied = team.ballot([&](Index lane) {
        bool any = false;
        for (int s = 0; s < in_cell; ++s) any = any || begin[s][lane] < end[s][lane];
        return any;
      });
      for (; occupied != 0; occupied &= occupied - 1) {
        const auto lane_of_cell = static_cast<Index>(std::countr_zero(occupied));
        for (int s = 0; s < in_cell; ++s) {
          const Index last = team.get(end[s], lane_of_cell);
          for (Index j = team.get(begin[s], lane_of_cell); j < last; j += Team::size) {
            found(j,
                  [&] { return team.ballot([&](Index lane) { return j + lane < last && near(place_of(j + lane)); }); });
          }
        }
      }
    }
  }

  /// found as in visit() for the neighbours of a cluster; walls need only fluid neighbours (sections = 1).
  template <class Team, class Found>
  HOST_DEVICE void search(Team& team, const Members& of, int sections, const Found& found) const {
    const auto place = [&](Index m, int k) { return of.place[m][k]; };
    const CellExtent<Dim> extent = this->extent_of(cluster_size, place);
    const LocalFrame<Dim> frame(this->lattice, cluster_size, place);
    if (extent.is_compact() && !frame.meets_itself(this->lattice, this->reach2)) {
      visit(team, extent, sections, near_any(of, frame), found);
      return;
    }
    // Four in a row that lie far apart (isolated grains, the edge of the domain): around each by itself.
    for (Index m = 0; m < of.count; ++m) {
      const Vec<Dim, std::int32_t> at = place_of(of.first + m);
      visit(team, this->extent_of(1, [&](Index, int k) { return at[k]; }), sections, NearOne{*this, of, m}, found);
    }
  }

  HOST_DEVICE Members members_of(const ClusterList& list, Index cluster) const {
    Members members{};
    members.first = list.first(cluster);
    members.count = list.last(cluster) - members.first;
    for (Index m = 0; m < cluster_size; ++m) {
      members.place[m] = place_of(members.first + (m < members.count ? m : members.count - 1));
    }
    return members;
  }
};

/// Counts the neighbours of a cluster, padded, and keeps its words of hits.
template <int Dim, int in_cell>
struct CountPass {
  using neighbours = Neighbours<field::place>;
  using reads = Reads<>;
  using writes = Writes<>;

  TeamSearch<Dim, in_cell> search;
  ClusterList list;
  std::uint32_t* kept;  // kept_words a cluster
  Index* counts;

  template <class Team>
  HOST_DEVICE void operator()(Index cluster, Team& team) const {
    Index n = 0;
    Index words = 0;
    std::uint32_t* const mine = kept + std::size_t{cluster} * kept_words<Dim>;
    search.search(team, search.members_of(list, cluster), cluster < list.fluid_clusters ? 2 : 1,
                  [&](Index, const auto& hits) {
                    const std::uint32_t word = hits();
                    n += static_cast<Index>(std::popcount(word));
                    if (words < kept_words<Dim>) team.once([&] { mine[words] = word; });
                    ++words;
                  });
    team.once([&] { counts[cluster] = (n + list_padding - 1) / list_padding * list_padding; });
  }
};

/// Writes the entries of a cluster, padded, and its marks.
template <int Dim, int in_cell>
struct WritePass {
  using neighbours = Neighbours<field::place>;
  using reads = Reads<>;
  using writes = Writes<>;

  TeamSearch<Dim, in_cell> search;
  ClusterList list;
  ClusterMarks marks;
  const std::uint32_t* kept;
  Index* entries;

  template <class Team>
  HOST_DEVICE void operator()(Index cluster, Team& team) const {
    Index at = list.begin[cluster];
    Index words = 0;
    std::uint32_t reached = 0;
    const std::uint32_t* const mine = kept + std::size_t{cluster} * kept_words<Dim>;
    search.search(team, search.members_of(list, cluster), cluster < list.fluid_clusters ? 2 : 1,
                  [&](Index first, const auto& hits) {
                    const std::uint32_t word = words < kept_words<Dim> ? mine[words] : hits();
                    ++words;
                    team.each([&](Index lane) {
                      if ((word >> lane & 1) != 0) entries[at + bits_below(word, lane)] = first + lane;
                    });
                    at += static_cast<Index>(std::popcount(word));
                    if (marks.phase == nullptr) return;
                    reached |= team.any_bits([&](Index lane) {
                      return (word >> lane & 1) != 0 ? std::uint32_t{marks.phase[first + lane]} : 0U;
                    });
                  });
    team.each([&](Index lane) {
      if (at + lane < list.begin[cluster + 1]) entries[at + lane] = list.none;
    });
    team.once([&] { marks.set(list, cluster, static_cast<std::uint8_t>(reached)); });
  }
};

/// Particle pass: copies the places into an array of their own.
struct PlacePass {
  using reads = Reads<field::place>;
  using writes = Writes<>;
  const Record* records;
  PlaceQuad* to;
  HOST_DEVICE void operator()(Index i) const {
    PlaceQuad quad{};
    for (int k = 0; k < 3; ++k) quad.c[k] = records[i].place[k];
    to[i] = quad;
  }
};

/// The search over the particles in their present order and places, with the array it reads.
template <int Dim, class Device>
struct TeamSearchArrays {
  Cells<Dim, Device> cells;
  typename Device::template Buffer<PlaceQuad> places;
  CellReach<Dim> search;

  TeamSearchArrays(Device& on, const Particles<Device>& p, const Scene<Dim>& scene)
      : cells(fill_cells<Dim>(on, p, scene)) {
    const auto reach = static_cast<float>(scene.list_reach);
    places.resize(p.with_copies());
    search = {cells.table, scene.lattice, reach * reach};
    on.for_each(p.with_copies(), PlacePass{p.record.data(), places.data()});
  }
};

/// Counts and writes the entries of every cluster, and its marks. Returns how many entries they are.
template <int Dim, int in_cell, class Device>
Index make_lists_by_teams(Device& on, Particles<Device>& p, const TeamSearch<Dim, in_cell>& search,
                          const ClusterMarks& marks, Index spare) {
  typename Device::template Buffer<Index> counts;
  typename Device::template Buffer<std::uint32_t> kept;
  counts.resize(p.clusters);
  kept.resize(std::size_t{p.clusters} * kept_words<Dim>);
  on.for_each_team(p.clusters, CountPass<Dim, in_cell>{search, p.list(), kept.data(), counts.data()});
  const Index total = on.exclusive_scan(counts, p.list_begin);
  p.list_entries.resize_anew(std::size_t{total} + spare);
  on.for_each_team(p.clusters, WritePass<Dim, in_cell>{search, p.list(), marks, kept.data(), p.list_entries.data()});
  return total;
}

/// The same, among this rank's particles alone or with copies of other ranks'.
template <int Dim, class Device>
Index make_lists_by_teams(Device& on, Particles<Device>& p, const TeamSearchArrays<Dim, Device>& arrays,
                          const ClusterMarks& marks, Index spare) {
  const auto make = [&]<int in_cell>() {
    const TeamSearch<Dim, in_cell> search{arrays.search, arrays.places.data()};
    return make_lists_by_teams(on, p, search, marks, spare);
  };
  return arrays.cells.table.sections == 2 ? make.template operator()<2>() : make.template operator()<most_sections>();
}

}  // namespace thalweg::neighbours
