#pragma once

#include "solver/lists/search.hpp"
#include "solver/lists/selection.hpp"

// Neighbour lists: particles are sorted along a Hilbert curve of cells one list reach wide, and every cluster of four
// consecutive ones gets one list of all particles within reach of any of them. The reach exceeds the kernel's support
// by a skin, so that a list serves until some particle has crossed half the skin.
namespace thalweg::neighbours {

/// Marks of a cluster: the phases in reach of it, and sediment among its members.
enum Marks : std::uint8_t { nothing = 0, reaches_sediment = 1, reaches_water = 2, has_sediment = 4 };

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
struct SearchArrays {
  Cells<Dim, Device> cells;
  typename Device::template Buffer<std::int32_t> places[Dim];
  ClusterSearch<Dim, Device> search;

  SearchArrays(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) : cells(fill_cells<Dim>(on, p, scene)) {
    const auto reach = static_cast<float>(scene.list_reach);
    search = {cells.table, scene.lattice, p.record.data(), {}, reach * reach};
    for (int k = 0; k < Dim; ++k) {
      places[k].resize(p.count + filter_overrun);
      search.places[k] = places[k].data();
      on.for_each(p.count, PlaceAlongPass{p.record.data(), axis<Dim>(k), places[k].data()});
    }
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

/// A byte a particle for its phase, where a record is a line of the cache.
template <class Device>
void mark_phases(Device& on, const Particles<Device>& p, typename Device::template Buffer<std::uint8_t>& phase) {
  phase.resize(p.count + filter_overrun);
  const Record* records = p.record.data();
  std::uint8_t* to = phase.data();
  on.for_each(
      p.count, declare<Reads<field::matter>, Writes<>>([=] HOST_DEVICE(Index i) {
        const Record& r = records[i];
        to[i] = static_cast<std::uint8_t>(is_sediment(r) ? reaches_sediment : is_water(r) ? reaches_water : nothing);
      }));
}

/// Writes the entries and the clusters' marks; `phase` is nullptr in a scene without sediment.
template <int Dim, class Device>
void write_entries(Device& on, Particles<Device>& p, const ClusterSearch<Dim, Device>& search, Index total,
                   const std::uint8_t* phase, std::uint8_t* marks) {
  const ClusterList list = p.list();
  Index* entries = p.list_entries.data();
  on.for_each(p.clusters, declare<Neighbours<field::place>, Reads<>, Writes<>>([=] HOST_DEVICE(Index cluster) {
                Index at = list.begin[cluster];
                std::uint8_t m = 0;
                search.search(list.first(cluster), list.last(cluster), cluster < list.fluid_clusters ? 2 : 1,
                              Write{entries, at, phase, m});
                for (Index i = list.first(cluster); phase != nullptr && i < list.last(cluster); ++i) {
                  if (phase[i] == reaches_sediment) m |= has_sediment;
                }
                for (; at < list.begin[cluster + 1]; ++at) entries[at] = list.count;
                marks[cluster] = m;
              }));
  on.for_each(2 * list_prefetch,
              declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index e) { entries[total + e] = list.count; }));
}

/// Lists the clusters apart, by what is in their reach.
template <int Dim, class Device>
void choose_clusters(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::uint8_t* marks) {
  const ClusterList list = p.list();
  const Index fluid_clusters = p.fluid_clusters;
  Selection<Device> selection(on);
  selection.choose(p.all_fluid(),
                   declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) { return (marks[c] & reaches_sediment) != 0; }),
                   p.clusters_with_sediment);
  selection.choose(p.all_fluid(),
                   declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) { return (marks[c] & reaches_sediment) == 0; }),
                   p.clusters_of_water);
  if (scene.needs_near_walls) {
    selection.choose(p.all_fluid(), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) {
                       for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
                         if (list.entries[e] >= list.fluid_count && list.entries[e] < list.count) return true;
                       }
                       return false;
                     }),
                     p.clusters_near_walls);
  }
  if (scene.has_states) {
    selection.choose(p.all_fluid(), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) {
                       constexpr std::uint8_t both = has_sediment | reaches_water;
                       return (marks[c] & both) == both;
                     }),
                     p.clusters_at_bed_surface);
  }
  selection.choose(
      p.clusters - p.fluid_clusters, [=] HOST_DEVICE(Index n) { return fluid_clusters + n; },
      declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) { return list.begin[c + 1] > list.begin[c]; }),
      p.clusters_of_walls);
  selection.finish();
}

/// Makes the lists for the particles in their present order and places.
template <int Dim, class Device>
void build_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const SearchArrays<Dim, Device> arrays(on, p, scene);
  p.fluid_clusters = (p.fluid_count + cluster_size - 1) / cluster_size;
  p.clusters = p.fluid_clusters + (p.count - p.fluid_count + cluster_size - 1) / cluster_size;
  const Index total = count_entries(on, p, arrays.search);
  typename Device::template Buffer<std::uint8_t> marks;
  typename Device::template Buffer<std::uint8_t> phase;
  marks.resize(p.clusters);
  if (scene.has_sediment) mark_phases(on, p, phase);
  write_entries(on, p, arrays.search, total, scene.has_sediment ? phase.data() : nullptr, marks.data());
  choose_clusters(on, p, scene, marks.data());
}

}  // namespace thalweg::neighbours
