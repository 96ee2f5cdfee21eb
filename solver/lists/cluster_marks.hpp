#pragma once

#include <cstdint>

#include "solver/state/cluster_list.hpp"

namespace thalweg::neighbours {

/// Marks of a cluster: the phases in reach of it, sediment among its members, and copies of other ranks' particles in reach.
enum Marks : std::uint8_t {
  nothing = 0,
  reaches_sediment = 1,
  reaches_water = 2,
  has_sediment = 4,
  reaches_walls = 8,
  reaches_copies = copies_in_reach
};

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

}  // namespace thalweg::neighbours
