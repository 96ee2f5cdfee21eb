#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "solver/backend/quad.hpp"
#include "solver/state/cluster_list.hpp"
#include "solver/state/pair_geometry.hpp"

namespace thalweg {

/// The pair sweep of one cluster on a CPU core: four particles meet several neighbours at a time, in packs. W is the
/// number of floats in a register; sums are computed in Real.
template <int W, class Real>
class OpenMpSweep {
  /// Pairs computed at a time: a register full, but no less than one neighbour of a cluster.
  static constexpr int pairs = std::max(W * int{sizeof(float)} / int{sizeof(Real)}, int{cluster_size});
  static constexpr int groups = pairs / int{cluster_size};
  using F = Pack<pairs>;  // as records hold them
  using L = Pack<pairs, Real>;
  using I = IntPack<pairs>;
  template <int Dim>
  using LaneOf = Lane<Dim, L, I>;
  using Members = std::array<Index, cluster_size>;

 public:
  /// Sums body.pair() over the list of a cluster, then calls end_of(i, sum) for its particles.
  template <int Dim, class From, class Body, class EndOf>
  static void visit(const ClusterList& list, Index cluster, const From* records, const PairMetric<Dim>& metric,
                    const Body& body, const EndOf& end_of) {
    constexpr bool has_geometry = std::is_same_v<From, Record>;
    constexpr unsigned quads = Body::neighbours::quads;
    const Index first = list.first(cluster);
    const Index last = list.last(cluster);
    Members member{};
    for (Index l = 0; l < cluster_size; ++l) member[l] = first + l < last ? first + l : last - 1;
    LaneOf<Dim> a{};
    read<Dim, quads>(a, ClusterReader<Dim, From>{records, member});

    typename Body::template Sum<L> sum{};
    const Index end = list.begin[cluster + 1];
    for (Index e = list.begin[cluster]; e < end; e += groups) {
      const Index* j = list.entries + e;
      if constexpr (has_geometry) {  // vectors of a neighbourhood stay in the first cache
        for (int g = 0; g < groups; ++g) __builtin_prefetch(records + j[list_prefetch + g]);
      }
      NeighbourReader<Dim, From> neighbours;
      for (int g = 0; g < groups; ++g) neighbours.of[g] = reinterpret_cast<const Quad*>(records + j[g]);
      LaneOf<Dim> b{};
      read<Dim, quads>(b, neighbours);
      PairGeometry<Dim, L> geometry{};
      if constexpr (has_geometry) {
        for (int k = 0; k < Dim; ++k) {
          geometry.r[k] = to_real<Real>(a.place[k] - b.place[k]) * L(metric.quantum[k]);
        }
        metric.template complete<Body::kernel>(geometry);
      }
      body.pair(a, b, geometry, std::size_t{e} * cluster_size, sum);
    }
    hand_out(sum, body, first, last, end_of);
  }

 private:
  /// Fills lanes with the four particles of a cluster, repeated in every group: read()'s transpose for neighbours.
  template <int Dim, class From>
  struct ClusterReader {
    static constexpr bool has_records = std::is_same_v<From, Record>;
    const From* records;
    const Members& member;

    template <int quad>
    void place(Vec<Dim, I>& v) const {
      for (int k = 0; k < Dim; ++k) v[k] = place_bits(entries(quad, axis<Dim>(k)));
    }
    template <int quad>
    void vector(Vec<Dim, L>& v) const {
      for (int k = 0; k < Dim; ++k) v[k] = to_real<Real>(entries(quad, axis<Dim>(k)));
    }
    template <int quad, int entry>
    void number(L& n) const {
      n = to_real<Real>(entries(quad, entry));
    }

    [[nodiscard]] F entries(int quad, int entry) const {
      Quad q{};
      for (Index l = 0; l < cluster_size; ++l) q[l] = reinterpret_cast<const Quad*>(records + member[l])[quad][entry];
      return repeat_quad<pairs>(q);
    }
  };

  /// Fills lanes with one neighbour a group, repeated for the four particles of the cluster.
  template <int Dim, class From>
  struct NeighbourReader {
    static constexpr bool has_records = std::is_same_v<From, Record>;
    const Quad* of[groups];

    template <int quad>
    [[nodiscard]] F load() const {
      return join_quads<pairs>([this](int g) { return of[g] + quad; });
    }
    template <int quad>
    void place(Vec<Dim, I>& v) const {
      const F q = load<quad>();
      v[0] = place_bits(splat_in_groups<0>(q));
      if constexpr (Dim == 3) v[1] = place_bits(splat_in_groups<1>(q));
      v[Dim - 1] = place_bits(splat_in_groups<2>(q));
    }
    template <int quad>
    void vector(Vec<Dim, L>& v) const {
      const F q = load<quad>();
      v[0] = to_real<Real>(splat_in_groups<0>(q));
      if constexpr (Dim == 3) v[1] = to_real<Real>(splat_in_groups<1>(q));
      v[Dim - 1] = to_real<Real>(splat_in_groups<2>(q));
    }
    template <int quad, int entry>
    void number(L& n) const {
      n = to_real<Real>(splat_in_groups<entry>(load<quad>()));
    }
  };

  /// The lanes of the fields a body declares; of Vectors, which have one quad, the work alone.
  template <int Dim, unsigned quads, class Reader>
  static void read(LaneOf<Dim>& lane, const Reader& reader) {
    if constexpr (Reader::has_records) {
      read_lane<Dim, quads>(lane, reader);
    } else {
      reader.template vector<0>(lane.work);
    }
  }

  static I place_bits(const F& numbers) { return (typename I::Vector)numbers.v; }

  /// Adds up the groups and calls end_of() for every particle of the cluster.
  template <class Sums, class Body, class EndOf>
  static void hand_out(const Sums& sum, const Body&, Index first, Index last, const EndOf& end_of) {
    constexpr bool ends_in_real = requires(const Body& body, const typename Body::template Sum<Real>& in_real) {
      body.end(Index{}, in_real);
    };
    using Packs = std::array<L, sizeof(sum) / sizeof(L)>;
    using End = std::conditional_t<ends_in_real, Real, float>;
    const auto packs = std::bit_cast<Packs>(sum);
    std::array<std::array<End, packs.size()>, cluster_size> scalar{};
    for (std::size_t f = 0; f < packs.size(); ++f) {
      const auto total = sum_groups(packs[f]);
      for (Index l = 0; l < cluster_size; ++l) scalar[l][f] = static_cast<End>(total[l]);
    }
    for (Index l = 0; l < last - first; ++l) {
      end_of(first + l, std::bit_cast<typename Body::template Sum<End>>(scalar[l]));
    }
  }
};

}  // namespace thalweg
