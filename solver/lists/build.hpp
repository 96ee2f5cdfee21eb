#pragma once

#include <type_traits>

#include "solver/lists/drift.hpp"
#include "solver/lists/entries.hpp"
#include "solver/lists/selection.hpp"
#include "solver/lists/team_search.hpp"

// Neighbour lists: particles are sorted along a Hilbert curve of cells one list reach wide, and every cluster of four
// consecutive ones gets one list of all particles within reach of any of them. The reach exceeds the kernel's support
// by a skin, so that a list serves for some steps (drift.hpp).
namespace thalweg::neighbours {

/// Makes the lists of all clusters, and their marks. Returns the number of entries.
template <int Dim, class Device, class Arrays>
Index make_entries(Device& on, Particles<Device>& p, const Arrays& arrays, const ClusterMarks& marks) {
  constexpr Index spare = 2 * list_prefetch;
  if constexpr (Device::is_host) {
    return on.template make_lists<Dim>(p.clusters, GroupSearch<Dim, Device>{arrays.search, p.list(), marks},
                                       p.list_begin, p.list_entries, spare);
  } else {
    return make_lists_by_teams(on, p, arrays, marks, spare);
  }
}

/// A byte a particle for what it adds to the marks of clusters that reach it, where a record is a line of the cache.
template <class Device>
void mark_phases(Device& on, const Particles<Device>& p, typename Device::template Buffer<std::uint8_t>& phase) {
  phase.resize(p.with_copies() + filter_overrun);
  const Record* records = p.record.data();
  std::uint8_t* to = phase.data();
  const Index own = p.count;
  on.for_each(p.with_copies(), declare<Reads<field::matter>, Writes<>>([=] HOST_DEVICE(Index i) {
                const Record& r = records[i];
                to[i] = static_cast<std::uint8_t>((is_sediment(r) ? reaches_sediment
                                                   : is_water(r)  ? reaches_water
                                                                  : reaches_walls) |
                                                  (i < own ? nothing : reaches_copies));
              }));
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
    selection.choose(p.all_fluid(),
                     declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index c) { return (marks[c] & reaches_walls) != 0; }),
                     p.clusters_near_walls);
  }
  if (scene.has_states || (scene.has_sediment && scene.mixing_length)) {
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
  const std::conditional_t<Device::is_host, GroupSearchArrays<Dim, Device>, TeamSearchArrays<Dim, Device>> arrays(
      on, p, scene);
  p.fluid_clusters = (p.fluid_count + cluster_size - 1) / cluster_size;
  p.clusters = p.fluid_clusters + (p.count - p.fluid_count + cluster_size - 1) / cluster_size;
  typename Device::template Buffer<std::uint8_t> phase;
  p.cluster_marks.resize(p.clusters);
  const bool asks_for_phases = scene.has_sediment || scene.needs_near_walls || p.copies.count() > 0;
  if (asks_for_phases) mark_phases(on, p, phase);
  const ClusterMarks asked{asks_for_phases ? phase.data() : nullptr, p.cluster_marks.data()};
  const Index total = make_entries<Dim>(on, p, arrays, asked);
  const Index none = p.with_copies();
  Index* entries = p.list_entries.data();
  on.for_each(2 * list_prefetch, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index e) { entries[total + e] = none; }));
  choose_clusters(on, p, scene, p.cluster_marks.data());
  fill_drift_blocks(on, p, arrays.cells.table);
}

}  // namespace thalweg::neighbours
