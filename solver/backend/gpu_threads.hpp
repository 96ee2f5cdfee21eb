#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "solver/state/cluster_list.hpp"
#include "solver/state/pair_geometry.hpp"

// The bodies of a GPU's threads: a pair sweep, and what buffers need.
namespace thalweg {

/// Fills a lane from the quads of one record.
template <int Dim>
struct RecordReader {
  struct alignas(16) Quad {
    float v[4];
  };
  Quad quad[4];

  /// Loads the quads a body declares, one 128-bit load each; the place always.
  template <unsigned quads>
  HOST_DEVICE void load(const void* record) {
    constexpr unsigned wanted = quads | quad_place;
    for (int q = 0; q < 4; ++q) {
      if ((wanted & (1U << q)) == 0) continue;
      const auto* from = static_cast<const char*>(__builtin_assume_aligned(record, 16)) + q * sizeof(Quad);
      memcpy(&quad[q], from, sizeof(Quad));
    }
  }

  template <int q>
  HOST_DEVICE void place(Vec<Dim, std::int32_t>& v) const {
    for (int k = 0; k < Dim; ++k) memcpy(&v[k], &quad[q].v[axis<Dim>(k)], sizeof(std::int32_t));
  }
  template <int q>
  HOST_DEVICE void vector(Vec<Dim, float>& v) const {
    for (int k = 0; k < Dim; ++k) v[k] = quad[q].v[axis<Dim>(k)];
  }
  template <int q, int entry>
  HOST_DEVICE void number(float& n) const {
    n = quad[q].v[entry];
  }
};

template <int Dim, unsigned quads>
HOST_DEVICE inline Lane<Dim, float, std::int32_t> read_record(const Record* record) {
  Lane<Dim, float, std::int32_t> lane{};
  RecordReader<Dim> reader;
  reader.template load<quads>(record);
  read_lane<Dim, quads>(lane, reader);
  return lane;
}

template <int Dim, unsigned quads>
HOST_DEVICE inline Lane<Dim, float, std::int32_t> read_record(const Vectors* vectors) {
  Lane<Dim, float, std::int32_t> lane{};
  for (int k = 0; k < Dim; ++k) lane.work[k] = vectors->work[axis<Dim>(k)];
  return lane;
}

/// The result of a sweep whose end() returns nothing.
struct NoResult {};

/// The pair sweep of one thread: particle n % 4 of the n/4-th cluster visited. The four threads of a cluster walk the
/// same list, so that a neighbour's record is fetched once for all of them. Result is what end() returns; a thread
/// without a particle returns `none`.
template <int Dim, class From, class Body, class Result>
struct SweepThread {
  ClusterList list;
  ClusterRange range;
  const From* records;
  PairMetric<Dim> metric;
  Body body;
  Result none;

  HOST_DEVICE Result operator()(Index n) const {
    const Index cluster = range[n / cluster_size];
    const Index i = list.first(cluster) + n % cluster_size;
    if (i >= list.last(cluster)) return none;
    constexpr unsigned quads = Body::neighbours::quads;
    const auto a = read_record<Dim, quads>(records + i);
    typename Body::template Sum<float> sum{};
    const Index end = list.begin[cluster + 1];
    for (Index e = list.begin[cluster]; e < end; ++e) {
      const auto b = read_record<Dim, quads>(records + list.entries[e]);
      PairGeometry<Dim, float> geometry{};
      if constexpr (std::is_same_v<From, Record>) {
        for (int k = 0; k < Dim; ++k) {
          geometry.r[k] = to_float(lane_difference(a.place[k], b.place[k])) * metric.quantum[k];
        }
        metric.template complete<Body::kernel>(geometry);
      }
      body.pair(a, b, geometry, std::size_t{e} * cluster_size + n % cluster_size, sum);
    }
    if constexpr (std::is_same_v<Result, NoResult>) {
      body.end(i, sum);
      return none;
    } else {
      return body.end(i, sum);
    }
  }
};

/// Keeps the result of a reduction.
template <class T>
struct Keep {
  T* to;
  HOST_DEVICE void operator()(const T& result) const { *to = result; }
};

template <class T>
struct FillThread {
  T* to;
  T value;
  HOST_DEVICE void operator()(Index i) const { to[i] = value; }
};

/// The first `sorted` entries in a new order, the others as they are.
template <class T>
struct ReorderThread {
  const T* from;
  const Index* order;
  T* to;
  Index sorted;
  HOST_DEVICE void operator()(Index i) const { to[i] = from[i < sorted ? order[i] : i]; }
};

}  // namespace thalweg
