#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include "physics/lane_math.hpp"

// Several pairs at a time on a CPU: W numbers, float or double, in one register. A pack is W/4 groups of four lanes; in
// a sweep group g holds neighbour g and lane l within every group holds particle l of the cluster
// (solver/backend/openmp.hpp).
// Built on the compiler's vector types, so that SSE, AVX2, AVX-512 and NEON share this text; the few operations the
// compiler does not turn into one instruction by itself are spelled out below.
namespace thalweg {

/// The widest pack of floats the instruction set of this translation unit holds.
#if defined(__AVX512F__)
inline constexpr int native_width = 16;
#elif defined(__AVX2__)
inline constexpr int native_width = 8;
#else
inline constexpr int native_width = 4;
#endif

template <int W, class Number>
struct RegisterOf {
  typedef Number Type __attribute__((vector_size(W * sizeof(Number))));
};
template <int W, class Number>
using Register = typename RegisterOf<W, Number>::Type;

/// Whole numbers, or conditions: all bits of a lane where it holds, none where it does not.
template <int W, class Int = std::int32_t>
struct IntPack {
  using Vector = Register<W, Int>;
  Vector v;

  IntPack() = default;
  IntPack(Vector vector) : v(vector) {}
  IntPack(Int value) : v(value - Vector{}) {}

  /// Wraps around, as the places of a lattice do (Lattice::difference).
  friend IntPack operator-(IntPack a, IntPack b) {
    using Unsigned = Register<W, std::make_unsigned_t<Int>>;
    return {(Vector)((Unsigned)a.v - (Unsigned)b.v)};
  }
  friend IntPack operator&(IntPack a, IntPack b) { return {a.v & b.v}; }
};

template <int W, class Real = float>
struct Pack {
  using Vector = Register<W, Real>;
  using Condition = IntPack<W, std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>>;
  Vector v;

  Pack() = default;
  Pack(Vector vector) : v(vector) {}
  Pack(Real value) : v(value - Vector{}) {}

  friend Pack operator+(Pack a, Pack b) { return a.v + b.v; }
  friend Pack operator-(Pack a, Pack b) { return a.v - b.v; }
  friend Pack operator*(Pack a, Pack b) { return a.v * b.v; }
  friend Pack operator-(Pack a) { return -a.v; }
  Pack& operator+=(Pack b) { return *this = *this + b; }

  friend Condition operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend Condition operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend Condition operator==(Pack a, Pack b) { return {a.v == b.v}; }
};

template <int W, class Real>
inline Pack<W, Real> lane_select(typename Pack<W, Real>::Condition condition, Pack<W, Real> yes, Pack<W, Real> no) {
  return condition.v ? yes.v : no.v;
}

template <int W>
inline IntPack<W> lane_difference(IntPack<W> a, std::int32_t b) {
  return a - IntPack<W>(b);
}
template <int W>
inline IntPack<W> lane_or(IntPack<W> a, IntPack<W> b) {
  return a.v | b.v;
}
template <int W>
inline IntPack<W> lane_and_not(IntPack<W> a, IntPack<W> b) {
  return a.v & ~b.v;
}

/// Bit l is set where condition holds in lane l.
template <int W>
inline std::uint32_t bits_of(IntPack<W> condition) {
  std::uint32_t bits = 0;
  for (int l = 0; l < W; ++l) bits |= (condition.v[l] != 0 ? 1U : 0U) << l;
  return bits;
}
#if defined(__AVX512F__)
template <>
inline std::uint32_t bits_of(IntPack<16> condition) {
  const auto v = (__m512i)condition.v;
  return _mm512_test_epi32_mask(v, v);
}
#endif
#if defined(__AVX2__)
template <>
inline std::uint32_t bits_of(IntPack<8> condition) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)condition.v));
}
#endif

/// Some of the W indices from `first` on: those whose bit is set.
template <int W>
struct Hits {
  std::uint32_t first;
  std::uint32_t bits;

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(std::popcount(bits)); }

  /// Writes them to `to`, in order and nothing behind them; returns how many they are.
  std::uint32_t write(std::uint32_t* to) const {
#if defined(__AVX512F__)
    if constexpr (W == 16) {
      const __m512i all = _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                                           _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
      const auto filled = static_cast<__mmask16>((1U << count()) - 1);
      _mm512_mask_storeu_epi32(to, filled, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), all));
      return count();
    }
#endif
    std::uint32_t n = 0;
    for (std::uint32_t left = bits; left != 0; left &= left - 1) {
      to[n++] = first + static_cast<std::uint32_t>(std::countr_zero(left));
    }
    return n;
  }

  /// The bits set in any of their entries of `flags`, which can be read for all W.
  [[nodiscard]] std::uint8_t any(const std::uint8_t* flags) const {
    constexpr std::uint64_t bytes = 0x0101010101010101;
    std::uint64_t found = 0;
    for (int l = 0; l < W; l += 8) {
      std::uint64_t eight = 0;
      __builtin_memcpy(&eight, flags + first + l, std::min<std::size_t>(W, 8));
      // Bit k of the eight becomes byte k: moved there, each beside the others, then all ones or none.
      const std::uint64_t apart = ((bits >> l & 0xffU) * bytes) & 0x8040201008040201;
      const std::uint64_t ones = (apart + 0x7f * bytes) | apart;
      found |= eight & ((ones >> 7U & bytes) * 0xff);
    }
    for (unsigned shift = 32; shift >= 8; shift /= 2) found |= found >> shift;
    return static_cast<std::uint8_t>(found);
  }
};

/// The same numbers in another precision.
template <class Real, int W, class From>
inline Pack<W, Real> to_real(Pack<W, From> a) {
  return __builtin_convertvector(a.v, Register<W, Real>);
}
template <class Real, int W>
inline Pack<W, Real> to_real(IntPack<W> a) {
  return __builtin_convertvector(a.v, Register<W, Real>);
}
template <int W>
inline Pack<W> to_float(IntPack<W> a) {
  return to_real<float>(a);
}

template <int W, class Real>
inline Pack<W, Real> lane_max(Pack<W, Real> a, Pack<W, Real> b) {
  return a.v > b.v ? a.v : b.v;
}
template <int W, class Real>
inline Pack<W, Real> lane_min(Pack<W, Real> a, Pack<W, Real> b) {
  return a.v < b.v ? a.v : b.v;
}
template <int W, class Real>
inline Pack<W, Real> lane_reciprocal(Pack<W, Real> a) {
  return Pack<W, Real>(1).v / a.v;
}
template <int W, class Real>
inline Pack<W, Real> lane_sqrt(Pack<W, Real> a) {
  Pack<W, Real> out;
  for (int k = 0; k < W; ++k) out.v[k] = std::sqrt(a.v[k]);
  return out;
}

// Estimates refined by one Newton step: relative error below 2e-7, a third of the cost of division and square root.
#if defined(__AVX512F__)
template <>
inline Pack<16> lane_max(Pack<16> a, Pack<16> b) {
  return Pack<16>::Vector(_mm512_max_ps(a.v, b.v));
}
template <>
inline Pack<16> lane_min(Pack<16> a, Pack<16> b) {
  return Pack<16>::Vector(_mm512_min_ps(a.v, b.v));
}
template <>
inline Pack<16> lane_reciprocal(Pack<16> a) {
  const Pack<16> x = Pack<16>::Vector(_mm512_rcp14_ps(a.v));
  return x * (Pack<16>(2.0F) - a * x);
}
template <>
inline Pack<16> lane_sqrt(Pack<16> a) {
  // a * rsqrt(a); the bound keeps a = 0 from becoming 0 * inf.
  const Pack<16> bounded = lane_max(a, Pack<16>(1e-30F));
  const Pack<16> x = Pack<16>::Vector(_mm512_rsqrt14_ps(bounded.v));
  return a * x * (Pack<16>(1.5F) - Pack<16>(0.5F) * bounded * x * x);
}
#endif
#if defined(__AVX2__)
template <>
inline Pack<8> lane_max(Pack<8> a, Pack<8> b) {
  return Pack<8>::Vector(_mm256_max_ps(a.v, b.v));
}
template <>
inline Pack<8> lane_min(Pack<8> a, Pack<8> b) {
  return Pack<8>::Vector(_mm256_min_ps(a.v, b.v));
}
template <>
inline Pack<8> lane_sqrt(Pack<8> a) {
  return Pack<8>::Vector(_mm256_sqrt_ps(a.v));
}
#endif

/// Coefficients of pairs are stored in single precision, as records are, whatever the precision of the sums.
template <int W, class Real>
inline void lane_store(float* to, Pack<W, Real> a) {
  const Pack<W> kept = to_real<float>(a);
  __builtin_memcpy(to, &kept.v, sizeof(kept.v));
}
template <int W, class Real>
inline void lane_load(const float* from, Pack<W, Real>& a) {
  Pack<W> kept;
  __builtin_memcpy(&kept.v, from, sizeof(kept.v));
  a = to_real<Real>(kept);
}
template <int W>
inline void lane_store(ShortFloat* to, Pack<W> a) {
  using Bits = Register<W, std::uint32_t>;
  const auto upper = __builtin_convertvector(((Bits)a.v + 0x4000U) >> 15U, Register<W, std::uint16_t>);
  __builtin_memcpy(to, &upper, sizeof(upper));
}
template <int W>
inline void lane_load(const ShortFloat* from, Pack<W>& a) {
  Register<W, std::uint16_t> upper;
  __builtin_memcpy(&upper, from, sizeof(upper));
  a.v = (typename Pack<W>::Vector)(__builtin_convertvector(upper, Register<W, std::uint32_t>) << 15U);
}
#if defined(__AVX512F__)
template <>
inline void lane_store(ShortFloat* to, Pack<16> a) {
  const __m512i rounded = _mm512_add_epi32((__m512i)a.v, _mm512_set1_epi32(0x4000));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm512_cvtepi32_epi16(_mm512_srli_epi32(rounded, 15)));
}
template <>
inline void lane_load(const ShortFloat* from, Pack<16>& a) {
  const __m512i upper = _mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
  a.v = (Pack<16>::Vector)_mm512_slli_epi32(upper, 15);
}
#endif

}  // namespace thalweg
