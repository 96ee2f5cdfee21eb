#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "solver/state/cluster_list.hpp"
#include "solver/state/pair_geometry.hpp"

// The bodies of a GPU's threads: a pair sweep, and what buffers need.
namespace thalweg {

/// Loads 16 bytes at once, on the device in its own words: the compiler makes two loads of one of which 12 bytes are used, and
/// the first cache works for each. Nothing that a sweep writes is read of neighbours, so that its order beside stores is free.
template <class Quad>
HOST_DEVICE inline void load_whole(Quad& quad, const void* from) {
  static_assert(sizeof(Quad) == 16);
#if defined(__CUDA_ARCH__)
  unsigned part[4];
  asm("ld.global.v4.u32 {%0, %1, %2, %3}, [%4];"
      : "=r"(part[0]), "=r"(part[1]), "=r"(part[2]), "=r"(part[3])
      : "l"(__cvta_generic_to_global(from)));
  memcpy(&quad, part, sizeof(quad));
#else
  memcpy(&quad, __builtin_assume_aligned(from, 16), sizeof(quad));
#endif
}

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
      load_whole(quad[q], static_cast<const char*>(record) + q * sizeof(Quad));
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
  Vectors all;
  load_whole(all, vectors);
  for (int k = 0; k < Dim; ++k) lane.work[k] = all.work[axis<Dim>(k)];
  return lane;
}

/// The result of a sweep whose end() returns nothing.
struct NoResult {};

/// Four entries of a list in one load; lists begin and end at multiples of four.
struct alignas(16) EntryQuad {
  Index entry[list_padding];
};
static_assert(list_padding == 4);
HOST_DEVICE inline EntryQuad read_entries(const Index* entries) {
  EntryQuad quad;
  load_whole(quad, entries);
  return quad;
}

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

  /// Neighbours on their way at a time: so many quads of them fit into registers beside the sum.
  static constexpr int quads_of_one =
      std::is_same_v<From, Record> ? std::popcount(Body::neighbours::quads | quad_place) : 1;
  static constexpr Index in_flight = quads_of_one > 3 ? 1 : quads_of_one > 2 ? 2 : 4;
  static_assert(list_padding % in_flight == 0);

  HOST_DEVICE PairGeometry<Dim, float> geometry_of(const Lane<Dim, float, std::int32_t>& a,
                                                   const Lane<Dim, float, std::int32_t>& b) const {
    PairGeometry<Dim, float> geometry{};
    if constexpr (std::is_same_v<From, Record>) {
      for (int k = 0; k < Dim; ++k) {
        geometry.r[k] = to_float(lane_difference(a.place[k], b.place[k])) * metric.quantum[k];
      }
      metric.template complete<Body::kernel>(geometry);
    }
    return geometry;
  }

  HOST_DEVICE Result operator()(Index n) const {
    const Index cluster = range[n / cluster_size];
    const Index i = list.first(cluster) + n % cluster_size;
    if (i >= list.last(cluster)) return none;
    constexpr unsigned quads = Body::neighbours::quads;
    const auto a = read_record<Dim, quads>(records + i);
    typename Body::template Sum<float> sum{};
    const Index end = list.begin[cluster + 1];
    for (Index e = list.begin[cluster]; e < end; e += list_padding) {
      const EntryQuad next = read_entries(list.entries + e);
      for (Index k = 0; k < list_padding; k += in_flight) {
        Lane<Dim, float, std::int32_t> b[in_flight];
        for (Index f = 0; f < in_flight; ++f) b[f] = read_record<Dim, quads>(records + next.entry[k + f]);
        for (Index f = 0; f < in_flight; ++f) {
          body.pair(a, b[f], geometry_of(a, b[f]), std::size_t{e + k + f} * cluster_size + n % cluster_size, sum);
        }
      }
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
