#pragma once

#include "solver/state/record.hpp"

namespace thalweg {

/// Particles per cluster: this many consecutive particles share one neighbour list.
inline constexpr Index cluster_size = 4;
/// Sums are added up in blocks of so many particles; where a scene lies on several ranks, each has whole blocks of the fluid.
inline constexpr Index sum_block = 512;
/// Lists are padded to a multiple of this with a record of zero volume, so that a sweep needs no remainder loop.
inline constexpr Index list_padding = 4;
/// A filter may read so many particles beyond those it is asked about (the widest pack).
inline constexpr Index filter_overrun = 16;
/// Neighbours are prefetched so many entries ahead of a sweep; the entries end with twice as many spare ones. So many records
/// fill a quarter of the first cache: with 12, sweeps beyond the caches took a fifth longer, with 384 no less.
inline constexpr Index list_prefetch = 192;

/// The number of particles of the fluid that a device has. A sum over them has the same bits on any number of ranks
/// (reduce). Over anything else it has if the terms are whole numbers, or if it is a largest or least one.
struct FluidCount {
  Index count = 0;
  operator Index() const { return count; }  // NOLINT(google-explicit-constructor): a count like any other
};

/// The bit of a cluster's mark that says that its list holds copies of other ranks' particles.
inline constexpr std::uint8_t copies_in_reach = 16;

/// The neighbour lists as a sweep needs them; views, valid until the next rebuild.
/// Cluster c < fluid_clusters holds particles 4c … of the fluid [0, fluid_count), the others those of the walls
/// [fluid_count, count). entries[begin[c] … begin[c+1]) are its neighbours, itself included; `none` pads them.
struct ClusterList {
  const Index* begin;
  const Index* entries;
  Index fluid_clusters;
  Index clusters;
  Index fluid_count;
  Index count;
  Index none;                 // the record of zero volume behind all particles
  const std::uint8_t* marks;  // of every cluster (copies_in_reach); nullptr: no list holds copies

  HOST_DEVICE Index first(Index c) const {
    return c < fluid_clusters ? c * cluster_size : fluid_count + (c - fluid_clusters) * cluster_size;
  }
  HOST_DEVICE Index last(Index c) const {
    const Index end = first(c) + cluster_size;
    const Index limit = c < fluid_clusters ? fluid_count : count;
    return end < limit ? end : limit;
  }
  /// The cluster of particle i. Those of the walls begin anew behind the fluid, whose last one may hold fewer than four.
  HOST_DEVICE Index cluster_of(Index i) const {
    return i < fluid_count ? i / cluster_size : fluid_clusters + (i - fluid_count) / cluster_size;
  }
};

/// Which clusters a sweep visits: all of [0, count), or those named in `clusters`.
struct ClusterRange {
  const Index* clusters;  // nullptr: 0, 1, 2 …
  Index count;

  HOST_DEVICE Index operator[](Index i) const { return clusters == nullptr ? i : clusters[i]; }
};

/// A part of a range: the clusters with copies of other ranks' particles in their lists, or those without.
struct ClusterPart {
  const std::uint8_t* marks = nullptr;  // nullptr: the whole range
  bool with_copies = false;

  HOST_DEVICE bool has(Index cluster) const {
    return marks == nullptr || ((marks[cluster] & copies_in_reach) != 0) == with_copies;
  }
  /// The same of the clusters [from, to) of a range, which are visited together: with copies if one of them has some.
  [[nodiscard]] bool has(const ClusterRange& range, Index from, Index to) const {
    if (marks == nullptr) return true;
    std::uint8_t found = 0;
    for (Index n = from; n < to; ++n) found |= marks[range[n]];
    return ((found & copies_in_reach) != 0) == with_copies;
  }
};

}  // namespace thalweg
