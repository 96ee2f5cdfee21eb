#pragma once

#include "solver/backend/pack.hpp"

// Quads in packs: four numbers of a record beside those of other records, and how they are spread over the lanes.
namespace thalweg {

/// Four neighbouring floats of a record; may_alias because a record's first three are integers.
using Quad = float __attribute__((vector_size(16), may_alias));

namespace detail {
template <std::size_t k, class Vector, std::size_t... i>
inline Vector splat_in_groups(Vector q, std::index_sequence<i...>) {
  return __builtin_shufflevector(q, q, int(i / 4 * 4 + k)...);
}
template <class Wide, class Narrow, std::size_t... i>
inline Wide join(Narrow low, Narrow high, std::index_sequence<i...>) {
  return __builtin_shufflevector(low, high, int(i)...);
}
}  // namespace detail

/// Entry k of every group of four, spread over its group.
template <std::size_t k, int W>
inline Pack<W> splat_in_groups(Pack<W> q) {
  return detail::splat_in_groups<k>(q.v, std::make_index_sequence<W>{});
}

/// W/4 quads read from the addresses `from(g)`, side by side.
template <int W, class From>
inline Pack<W> join_quads(const From& from) {
  if constexpr (W == 4) {
    return typename Pack<4>::Vector(*from(0));
#if defined(__AVX512F__)
  } else if constexpr (W == 16) {
    // Loads that write a quarter each: no shuffles, of which a sweep has enough.
    const auto quad = [&](int g) { return reinterpret_cast<const float*>(from(g)); };
    __m512 joined = _mm512_castps128_ps512(_mm_load_ps(quad(0)));
    joined = _mm512_mask_broadcast_f32x4(joined, 0x00f0, _mm_load_ps(quad(1)));
    joined = _mm512_mask_broadcast_f32x4(joined, 0x0f00, _mm_load_ps(quad(2)));
    joined = _mm512_mask_broadcast_f32x4(joined, 0xf000, _mm_load_ps(quad(3)));
    return typename Pack<W>::Vector(joined);
#endif
  } else {
    using Half = typename Pack<W / 2>::Vector;
    const Half low = join_quads<W / 2>(from).v;
    const Half high = join_quads<W / 2>([&](int g) { return from(g + W / 8); }).v;
    return detail::join<typename Pack<W>::Vector>(low, high, std::make_index_sequence<W>{});
  }
}

/// The same quad in every group.
template <int W>
inline Pack<W> repeat_quad(Quad q) {
  return join_quads<W>([&](int) { return &q; });
}

/// Lane-wise sum over the groups: entry l is the sum of what particle l met.
template <int W, class Real>
inline Register<4, Real> sum_groups(Pack<W, Real> a) {
  if constexpr (W == 4) {
    return a.v;
  } else {
    using Half = Register<W / 2, Real>;
    const auto* halves = reinterpret_cast<const Half*>(&a.v);
    return sum_groups(Pack<W / 2, Real>(halves[0] + halves[1]));
  }
}

}  // namespace thalweg
