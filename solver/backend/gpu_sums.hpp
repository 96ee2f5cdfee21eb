#pragma once

#include "solver/state/cluster_list.hpp"

// The threads of sums that have the same bits on any number of GPUs: terms are combined in their order, in chunks of a
// fixed number of particles, and these in the blocks of sums that ranks share (SharedScene).
namespace thalweg {

/// Particles whose terms one thread combines.
inline constexpr Index sum_chunk = 32;
static_assert(sum_block % sum_chunk == 0 && sum_chunk % cluster_size == 0);

/// body(n) for the places n of those of a range's clusters, four places a cluster, that belong to a part of it.
template <class Body>
struct PartThread {
  ClusterPart part;
  ClusterRange range;
  Body body;
  HOST_DEVICE void operator()(Index n) const {
    if (part.has(range[n / cluster_size])) body(n);
  }
};

/// Keeps the term of every place.
template <class Of, class T>
struct KeepThread {
  Of of;
  T* to;
  HOST_DEVICE void operator()(Index n) const { to[n] = of(n); }
};

/// An entry of an array as a term.
template <class T>
struct EntryTerm {
  const T* entries;
  HOST_DEVICE T operator()(Index n) const { return entries[n]; }
};

/// Combines so many terms in a row.
template <class T, class Of, class Combine>
struct FoldThread {
  Index n;      // terms
  Index width;  // terms a thread
  T start;
  Of of;
  Combine combine;
  T* to;

  HOST_DEVICE void operator()(Index c) const {
    const Index end = (c + 1) * width < n ? (c + 1) * width : n;
    T sum = start;
    for (Index i = c * width; i < end; ++i) sum = combine(sum, of(i));
    to[c] = sum;
  }
};

/// Combines what the clusters of a range have in a chunk of particles; their terms stand four a cluster, in the order of the
/// range, which is that of the particles.
template <class T, class Combine>
struct FoldClustersThread {
  ClusterRange range;
  T start;
  const T* terms;
  Combine combine;
  T* to;

  HOST_DEVICE void operator()(Index c) const {
    constexpr Index clusters = sum_chunk / cluster_size;
    const Index end = first_of(c * clusters + clusters) * cluster_size;
    T sum = start;
    for (Index n = first_of(c * clusters) * cluster_size; n < end; ++n) sum = combine(sum, terms[n]);
    to[c] = sum;
  }

  /// The first place in the range with this cluster or one behind it.
  [[nodiscard]] HOST_DEVICE Index first_of(Index cluster) const {
    if (range.clusters == nullptr) return cluster < range.count ? cluster : range.count;
    Index low = 0;
    Index high = range.count;
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      if (range.clusters[middle] < cluster) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
};

/// Hands a sum that the host has found to what follows.
template <class T, class Then>
struct ThenThread {
  T total;
  Then then;
  HOST_DEVICE void operator()(Index) const { then(total); }
};

}  // namespace thalweg
