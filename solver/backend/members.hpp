#pragma once

#include "solver/backend/device.hpp"

// Loops over the particles of some clusters.
namespace thalweg {

/// The neighbours' fields of a body, if it looks at any.
template <class Body>
struct NeighboursOf {};
template <DeclaresNeighbours Body>
struct NeighboursOf<Body> {
  using neighbours = typename Body::neighbours;
};

/// Calls body(i) for every particle of the clusters in a range.
template <class Body>
struct MemberPass : NeighboursOf<Body> {
  using reads = typename Body::reads;
  using writes = typename Body::writes;
  ClusterList list;
  ClusterRange range;
  Body body;

  HOST_DEVICE void operator()(Index n) const {
    const Index c = range[n / cluster_size];
    const Index i = list.first(c) + n % cluster_size;
    if (i < list.last(c)) body(i);
  }
};

/// The term of(i) of every such particle; `none` of a place without one.
template <class Of, class T>
struct MemberTerm : NeighboursOf<Of> {
  using reads = typename Of::reads;
  using writes = typename Of::writes;
  ClusterList list;
  ClusterRange range;
  Of of;
  T none;

  HOST_DEVICE T operator()(Index n) const {
    const Index c = range[n / cluster_size];
    const Index i = list.first(c) + n % cluster_size;
    return i < list.last(c) ? of(i) : none;
  }
};

/// The terms of a cluster's particles together.
template <class Of, class T, class Combine>
struct ClusterTerm : NeighboursOf<Of> {
  using reads = typename Of::reads;
  using writes = typename Of::writes;
  ClusterList list;
  Of of;
  T start;
  Combine combine;

  HOST_DEVICE T operator()(Index c) const {
    T sum = start;
    for (Index i = list.first(c); i < list.last(c); ++i) sum = combine(sum, of(i));
    return sum;
  }
};

template <class Device, class Body>
void for_each_member(Device& on, const ClusterList& list, ClusterRange range, const Body& body) {
  require_particle_body<Body>();
  on.for_each(range.count * cluster_size, MemberPass<Body>{{}, list, range, body});
}

/// then() of the sum of of(i) over those particles.
template <class Device, class T, class Of, class Combine, class Then>
void reduce_members_then(Device& on, const ClusterList& list, ClusterRange range, const T& start, const Of& of,
                         const Combine& combine, const Then& then) {
  require_particle_body<Of>();
  if constexpr (Device::is_host) {
    on.reduce_clusters_then(list, range, start, ClusterTerm<Of, T, Combine>{{}, list, of, start, combine}, combine,
                            then);
  } else {
    on.reduce_members_then(list, range, start, MemberTerm<Of, T>{{}, list, range, of, start}, combine, then);
  }
}

}  // namespace thalweg
