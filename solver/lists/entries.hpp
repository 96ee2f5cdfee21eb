#pragma once

#include <algorithm>
#include <cmath>

#include "solver/lists/cluster_marks.hpp"
#include "solver/lists/search.hpp"

// The entries of the neighbour lists as a CPU finds them: for several clusters together, once. A GPU's are found by teams of
// threads (team_search.hpp).
namespace thalweg::neighbours {

/// The search for some clusters in a row, whose neighbours are mostly the same: those near all of them are gathered
/// once (backend/openmp_lists.hpp). Clusters that lie apart are searched for one by one.
template <int Dim, class Device>
struct GroupSearch {
  using neighbours = Neighbours<field::place>;
  using reads = Reads<>;
  using writes = Writes<>;

  ClusterSearch<Dim, Device> search;
  ClusterList list;
  ClusterMarks marks;

  static constexpr Index together = Device::clusters_together;
  [[nodiscard]] Index fluid_groups() const { return (list.fluid_clusters + together - 1) / together; }
  [[nodiscard]] Index groups() const {
    return fluid_groups() + (list.clusters - list.fluid_clusters + together - 1) / together;
  }
  [[nodiscard]] Index first_cluster(Index group) const {
    return group < fluid_groups() ? group * together : list.fluid_clusters + (group - fluid_groups()) * together;
  }
  [[nodiscard]] Index last_cluster(Index group) const {
    return std::min(first_cluster(group) + together, group < fluid_groups() ? list.fluid_clusters : list.clusters);
  }

  template <class Lists>
  void operator()(Index group, Lists& lists) const {
    const Index from = first_cluster(group);
    const Index to = last_cluster(group);
    const Index first = list.first(from);
    const Index last = list.last(to - 1);
    const int sections = from < list.fluid_clusters ? 2 : 1;
    const auto extent = search.extent_of_members(first, last);
    const LocalFrame<Dim> local(search.lattice, last - first,
                                [&](Index m, int k) { return search.place_of(first + m, k); });
    if (!extent.is_compact() || local.meets_itself(search.lattice, search.reach2)) {
      return search_apart(from, to, sections, lists);
    }
    const typename Lists::Frame frame{local.middle, local.half, search.lattice.quantum,
                                      LocalFrame<Dim>::rounding * search.reach2};
    lists.gather_around(frame);
    search.each_range(extent, sections, [&](Index begin, Index end) { lists.gather(search.places, begin, end); });
    lists.end_gathering(marks.phase);
    for (Index c = from; c < to; ++c) {
      Vec<Dim, float> members[cluster_size];
      for (Index m = 0; m < cluster_size; ++m) {
        members[m] = relative(std::min(list.first(c) + m, list.last(c) - 1), frame.middle);
      }
      std::uint8_t reached = 0;
      lists.choose(members, frame.reach2, marks.phase != nullptr, reached);
      lists.end_list(list.none);
      marks.set(list, c, reached);
    }
  }

 private:
  /// A particle's place [m].
  [[nodiscard]] Vec<Dim, float> relative(Index i, const Vec<Dim, std::int32_t>& middle) const {
    Vec<Dim, float> x{};
    for (int k = 0; k < Dim; ++k) {
      x[k] = to_float(lane_difference(search.place_of(i, k), middle[k])) * search.lattice.quantum[k];
    }
    return x;
  }

  template <class Lists>
  void search_apart(Index from, Index to, int sections, Lists& lists) const {
    for (Index c = from; c < to; ++c) {
      std::uint8_t reached = 0;
      search.search(list.first(c), list.last(c), sections, [&](const auto& hits) {
        lists.add(hits);
        if (marks.phase != nullptr) reached |= hits.any(marks.phase);
      });
      lists.end_list(list.none);
      marks.set(list, c, reached);
    }
  }
};

/// Particle pass: copies one direction of the places into an array of its own.
struct PlaceAlongPass {
  using reads = Reads<field::place>;
  using writes = Writes<>;
  const Record* records;
  int component;
  std::int32_t* to;
  HOST_DEVICE void operator()(Index i) const { to[i] = records[i].place[component]; }
};

/// The search over the particles in their present order and places, with the arrays it reads.
template <int Dim, class Device>
struct GroupSearchArrays {
  Cells<Dim, Device> cells;
  typename Device::template Buffer<std::int32_t> places[Dim];
  ClusterSearch<Dim, Device> search;

  GroupSearchArrays(Device& on, const Particles<Device>& p, const Scene<Dim>& scene)
      : cells(fill_cells<Dim>(on, p, scene)) {
    const auto reach = static_cast<float>(scene.list_reach);
    search = {{cells.table, scene.lattice, reach * reach}, p.record.data(), {}};
    for (int k = 0; k < Dim; ++k) {
      places[k].resize(p.with_copies() + filter_overrun);
      search.places[k] = places[k].data();
      on.for_each(p.with_copies(), PlaceAlongPass{p.record.data(), axis<Dim>(k), places[k].data()});
    }
  }
};

}  // namespace thalweg::neighbours
