#include "solver/backend/quad.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace thalweg {
namespace {

/// The pack types of every width work on any processor (the compiler splits what the hardware has not), so all are
/// tested.
template <class T>
class PackOfWidth : public testing::Test {};
using Widths =
    testing::Types<std::integral_constant<int, 4>, std::integral_constant<int, 8>, std::integral_constant<int, 16>>;
TYPED_TEST_SUITE(PackOfWidth, Widths);

template <int W>
Pack<W> counting(float from, float step) {
  Pack<W> p(0.0F);
  for (int k = 0; k < W; ++k) p.v[k] = from + step * static_cast<float>(k);
  return p;
}

TYPED_TEST(PackOfWidth, ArithmeticEqualsScalar) {
  constexpr int W = TypeParam::value;
  const Pack<W> a = counting<W>(-2.5F, 0.7F);
  const Pack<W> b = counting<W>(3.0F, -0.4F);
  for (int k = 0; k < W; ++k) {
    EXPECT_EQ((a + b).v[k], a.v[k] + b.v[k]);
    EXPECT_EQ((a * b).v[k], a.v[k] * b.v[k]);
    EXPECT_EQ(lane_max(a, b).v[k], std::max(a.v[k], b.v[k]));
    EXPECT_EQ(lane_min(a, b).v[k], std::min(a.v[k], b.v[k]));
    EXPECT_EQ(lane_select(a < b, a, b).v[k], a.v[k] < b.v[k] ? a.v[k] : b.v[k]);
  }
}

TYPED_TEST(PackOfWidth, RootAndReciprocalAreGoodToSingleRounding) {
  constexpr int W = TypeParam::value;
  for (const float scale : {1e-12F, 1e-6F, 1.0F, 1e6F}) {
    const Pack<W> a = counting<W>(scale, 0.3F * scale);
    for (int k = 0; k < W; ++k) {
      EXPECT_NEAR(lane_sqrt(a).v[k] / std::sqrt(a.v[k]), 1, 3e-7);
      EXPECT_NEAR(lane_reciprocal(a).v[k] * a.v[k], 1, 3e-7);
    }
  }
  EXPECT_EQ(lane_sqrt(Pack<W>(0.0F)).v[0], 0);
}

TYPED_TEST(PackOfWidth, HalfAFloatKeepsItsSizeToOneIn512) {
  constexpr int W = TypeParam::value;
  for (const float size : {1e-30F, 3e-4F, 1.0F, 7e20F}) {
    const Pack<W> a = counting<W>(size, 0.37F * size);
    std::array<ShortFloat, W> kept{};
    lane_store(kept.data(), a);
    Pack<W> back;
    lane_load(kept.data(), back);
    for (int k = 0; k < W; ++k) {
      ShortFloat alone{};
      float alone_back = 0;
      lane_store(&alone, a.v[k]);
      lane_load(&alone, alone_back);
      EXPECT_EQ(back.v[k], alone_back);
      EXPECT_NEAR(back.v[k], a.v[k], a.v[k] / 512);
    }
  }
  std::array<ShortFloat, W> zeros{};
  Pack<W> back = counting<W>(1, 1);
  lane_store(zeros.data(), Pack<W>(0.0F));
  lane_load(zeros.data(), back);
  for (int k = 0; k < W; ++k) EXPECT_EQ(back.v[k], 0);
}

TYPED_TEST(PackOfWidth, GroupsAreFour) {
  constexpr int W = TypeParam::value;
  const Pack<W> a = counting<W>(0, 1);
  const Pack<W> third = splat_in_groups<2>(a);
  const Quad sum = sum_groups(a);
  for (int k = 0; k < W; ++k) EXPECT_EQ(third.v[k], static_cast<float>(k / 4 * 4 + 2));
  for (int l = 0; l < 4; ++l) {
    float expected = 0;
    for (int g = 0; g < W / 4; ++g) expected += static_cast<float>(4 * g + l);
    EXPECT_EQ(sum[l], expected);
  }
}

TYPED_TEST(PackOfWidth, JoinsQuadsFromScatteredPlaces) {
  constexpr int W = TypeParam::value;
  alignas(64) std::array<float, 128> memory{};
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<float>(i);
  const auto at = [&](int g) { return reinterpret_cast<const Quad*>(&memory[static_cast<std::size_t>(16 * (3 - g))]); };
  const Pack<W> p = join_quads<W>(at);
  for (int k = 0; k < W; ++k) EXPECT_EQ(p.v[k], static_cast<float>(16 * (3 - k / 4) + k % 4));
}

}  // namespace
}  // namespace thalweg
