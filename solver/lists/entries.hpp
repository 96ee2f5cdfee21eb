#pragma once

#include <algorithm>
#include <cmath>

#include "solver/lists/search.hpp"

// The entries of the neighbour lists, and what lies in reach of each cluster. A device that searches for several clusters
// together (Device::clusters_together > 1) searches once; any other counts first and writes then.
namespace thalweg::neighbours {

/// Marks of a cluster: the phases in reach of it, and sediment among its members.
enum Marks : std::uint8_t { nothing = 0, reaches_sediment = 1, reaches_water = 2, has_sediment = 4, reaches_walls = 8 };

/// The marks of all clusters, and how they are found.
struct ClusterMarks {
  const std::uint8_t* phase;  // what each particle adds to Marks; nullptr: nobody asks
  std::uint8_t* of;           // each cluster

  HOST_DEVICE void set(const ClusterList& list, Index cluster, std::uint8_t reached) const {
    for (Index i = list.first(cluster); phase != nullptr && i < list.last(cluster); ++i) {
      if (phase[i] == reaches_sediment) reached |= has_sediment;
    }
    of[cluster] = reached;
  }
};

/// Counts what a search finds.
struct Count {
  Index& n;
  template <class Hits>
  HOST_DEVICE void operator()(const Hits& hits) const {
    n += hits.count();
  }
};

/// Writes what a search finds one after the other; gathers the bits of its marks, if there are any.
struct Write {
  Index* entries;
  Index& at;
  const std::uint8_t* marks;
  std::uint8_t& gathered;
  template <class Hits>
  HOST_DEVICE void operator()(const Hits& hits) const {
    at += hits.write(entries + at);
    if (marks != nullptr) gathered |= hits.any(marks);
  }
};

/// Counts the neighbours of every cluster, padded; gives the lists their room. Returns the number of entries.
template <int Dim, class Device>
Index count_entries(Device& on, Particles<Device>& p, const ClusterSearch<Dim, Device>& search) {
  const ClusterList list = p.list();
  typename Device::template Buffer<Index> counts;
  counts.resize(p.clusters);
  Index* c = counts.data();
  on.for_each(p.clusters, declare<Neighbours<field::place>, Reads<>, Writes<>>([=] HOST_DEVICE(Index cluster) {
                Index n = 0;
                search.search(list.first(cluster), list.last(cluster), cluster < list.fluid_clusters ? 2 : 1, Count{n});
                c[cluster] = (n + list_padding - 1) / list_padding * list_padding;
              }));
  const Index total = on.exclusive_scan(counts, p.list_begin);
  p.list_entries.resize(std::size_t{total} + std::size_t{2} * list_prefetch);
  return total;
}

/// Counts and writes the entries of every cluster. Returns how many they are.
template <int Dim, class Device>
Index search_alone(Device& on, Particles<Device>& p, const ClusterSearch<Dim, Device>& search,
                   const ClusterMarks& marks) {
  const Index total = count_entries(on, p, search);
  const ClusterList list = p.list();
  Index* entries = p.list_entries.data();
  on.for_each(p.clusters, declare<Neighbours<field::place>, Reads<>, Writes<>>([=] HOST_DEVICE(Index cluster) {
                Index at = list.begin[cluster];
                std::uint8_t reached = 0;
                search.search(list.first(cluster), list.last(cluster), cluster < list.fluid_clusters ? 2 : 1,
                              Write{entries, at, marks.phase, reached});
                for (; at < list.begin[cluster + 1]; ++at) entries[at] = list.count;
                marks.set(list, cluster, reached);
              }));
  return total;
}

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
    const auto box = search.box_of(first, last);
    const auto frame = frame_of<typename Lists::Frame>(first, last);
    if (!search.is_compact(box) || meets_itself(frame)) return search_apart(from, to, sections, lists);
    lists.gather_around(frame);
    search.each_range(box, sections, [&](Index begin, Index end) { lists.gather(search.places, begin, end); });
    lists.end_gathering(marks.phase);
    for (Index c = from; c < to; ++c) {
      Vec<Dim, float> members[cluster_size];
      for (Index m = 0; m < cluster_size; ++m) {
        members[m] = relative(std::min(list.first(c) + m, list.last(c) - 1), frame.middle);
      }
      std::uint8_t reached = 0;
      lists.choose(members, rounding * search.reach2, marks.phase != nullptr, reached);
      lists.end_list(list.count);
      marks.set(list, c, reached);
    }
  }

 private:
  /// Of squares of distances up to a few reaches, in single precision.
  static constexpr float rounding = 1.00001F;

  [[nodiscard]] std::int32_t place(Index i, int k) const { return search.records[i].place[axis<Dim>(k)]; }

  /// A particle's place [m].
  [[nodiscard]] Vec<Dim, float> relative(Index i, const Vec<Dim, std::int32_t>& middle) const {
    Vec<Dim, float> x{};
    for (int k = 0; k < Dim; ++k) {
      x[k] = to_float(lane_difference(place(i, k), middle[k])) * search.lattice.quantum[k];
    }
    return x;
  }

  template <class Frame>
  [[nodiscard]] Frame frame_of(Index first, Index last) const {
    Frame frame{};
    frame.quantum = search.lattice.quantum;
    frame.reach2 = rounding * search.reach2;
    for (int k = 0; k < Dim; ++k) {
      std::int64_t low = 0;  // from the first one's place
      std::int64_t high = 0;
      for (Index i = first + 1; i < last; ++i) {
        const std::int64_t d = lane_difference(place(i, k), place(first, k));
        low = std::min(low, d);
        high = std::max(high, d);
      }
      frame.middle[k] = lane_difference(place(first, k), static_cast<std::int32_t>(-(low + high) / 2));
      const auto half = (high - low + 2) / 2;
      frame.half[k] = rounding * static_cast<float>(half) * search.lattice.quantum[k];
    }
    return frame;
  }

  /// True if the reach around a frame is wider than a period: then a place has several images near the frame.
  template <class Frame>
  [[nodiscard]] bool meets_itself(const Frame& frame) const {
    const double reach = std::sqrt(frame.reach2);
    bool meets = false;
    for (int k = 0; k < Dim; ++k) {
      meets = meets || (search.lattice.periodic[k] && 2 * (reach + frame.half[k]) > search.lattice.range[k]);
    }
    return meets;
  }

  template <class Lists>
  void search_apart(Index from, Index to, int sections, Lists& lists) const {
    for (Index c = from; c < to; ++c) {
      std::uint8_t reached = 0;
      search.search(list.first(c), list.last(c), sections, [&](const auto& hits) {
        lists.add(hits);
        if (marks.phase != nullptr) reached |= hits.any(marks.phase);
      });
      lists.end_list(list.count);
      marks.set(list, c, reached);
    }
  }
};

/// Makes the lists of all clusters, and their marks.
template <int Dim, class Device>
void make_entries(Device& on, Particles<Device>& p, const ClusterSearch<Dim, Device>& search,
                  const ClusterMarks& marks) {
  Index total = 0;
  if constexpr (Device::clusters_together > 1) {
    total = on.template make_lists<Dim>(p.clusters, GroupSearch<Dim, Device>{search, p.list(), marks}, p.list_begin,
                                        p.list_entries, 2 * list_prefetch);
  } else {
    total = search_alone(on, p, search, marks);
  }
  const Index none = p.count;
  Index* entries = p.list_entries.data();
  on.for_each(2 * list_prefetch, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index e) { entries[total + e] = none; }));
}

}  // namespace thalweg::neighbours
