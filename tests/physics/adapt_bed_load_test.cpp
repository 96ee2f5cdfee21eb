#include "physics/bed/adapt_bed_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/bed/advance_bed.hpp"
#include "tests/physics/sand_bed.hpp"

// Bed load that comes to the law's rate over a length, against the exact solutions of dq/dx = (q_law - q)/L.
namespace thalweg {
namespace {

constexpr double rate = 1e-5;    // [m^2/s] of the law
constexpr double length = 0.03;  // [m] L

GrainColumns bed_of(int nx, int ny, double width) {
  GrainColumns bed = test::bed_of(nx, ny, width, test::sand(), 0.05);
  bed.end.assign(bed.grains.size(), BedEnd::closed);
  return bed;
}

/// Shares of the law's rate under a flow along (x, y) [-], the law's rate where has_grains(column).
template <class HasGrains>
std::vector<double> shares(const GrainColumns& bed, double x, double y, const HasGrains& has_grains) {
  const auto passages = find_passages(bed, [&](int column, int axis, bool forward) {
    const double along = (axis == 0 ? x : y) * (forward ? 1 : -1);
    return has_grains(column) && along > 0 ? rate * along : 0.0;
  });
  return share_of_law(
      bed, passages, [](int) { return length; }, [&](int) { return bed.grid.dx / (std::abs(x) + std::abs(y)); });
}

constexpr auto everywhere = [](int) { return true; };

TEST(AdaptBedLoad, ComesToTheLawsRateBehindAFixedFloor) {
  for (const double width : {0.02, 0.01, 0.0025}) {
    const int columns = static_cast<int>(std::lround(0.2 / width));
    const GrainColumns bed = bed_of(columns, 1, width);
    const auto share = shares(bed, 1, 0, everywhere);
    for (int c = 0; c + 1 < columns; ++c) {
      EXPECT_NEAR(share[GrainColumns::at(c)], 1 - std::exp(-(c + 1) * width / length), 1e-12) << width << " " << c;
    }
  }
}

TEST(AdaptBedLoad, AgainstTheAxisToo) {
  const GrainColumns bed = bed_of(40, 1, 0.005);
  const auto share = shares(bed, -1, 0, everywhere);
  for (int c = 1; c < 40; ++c) {
    EXPECT_NEAR(share[GrainColumns::at(c)], 1 - std::exp(-(40 - c) * 0.005 / length), 1e-12) << c;
  }
}

// Across a corner of the bed the way from the floor to a place is the same wherever the flow came in.
TEST(AdaptBedLoad, ObliqueFlowGoesAsFar) {
  for (const double width : {0.005, 0.0025}) {
    const int n = static_cast<int>(std::lround(0.2 / width));
    const GrainColumns bed = bed_of(n, n, width);
    const double diagonal = std::sqrt(0.5);
    const auto share = shares(bed, diagonal, diagonal, everywhere);
    // Far from the corner, 15 mm behind the edge x = 0: 21.2 mm of the flow's way.
    const int at = static_cast<int>(std::lround(0.015 / width)) - 1;
    const double exact = 1 - std::exp(-(at + 1) * width / diagonal / length);
    EXPECT_NEAR(share[GrainColumns::at((n - 10) * n + at)], exact, 0.06 * exact) << width;
  }
}

TEST(AdaptBedLoad, UniformBedsSendTheLawsRate) {
  GrainColumns around = bed_of(40, 1, 0.005);
  around.grid.periodic_x = true;
  for (const double share : shares(around, 1, 0, everywhere)) EXPECT_NEAR(share, 1, 1e-12);
  GrainColumns fed = bed_of(40, 1, 0.005);
  fed.end.front() = BedEnd::fed;
  fed.end.back() = BedEnd::forth_x;
  for (const double share : shares(fed, 1, 0, everywhere)) EXPECT_NEAR(share, 1, 1e-12);
}

// A current at ease behind a faster one: q falls from the faster one's rate to its own as exp(-x/L).
TEST(AdaptBedLoad, OverloadsAQuieterReach) {
  GrainColumns bed = bed_of(80, 1, 0.005);
  bed.end.front() = BedEnd::fed;
  const auto passages = find_passages(bed, [&](int column, int axis, bool forward) {
    return axis == 0 && forward ? (column < 20 ? 2 * rate : rate) : 0.0;
  });
  const auto share = share_of_law(
      bed, passages, [](int) { return length; }, [](int) { return 0.005; });
  for (int c = 20; c < 79; ++c) {
    EXPECT_NEAR(share[GrainColumns::at(c)], 1 + std::exp(-(c - 19) * 0.005 / length), 1e-9) << c;
  }
}

// All that came in stays where nothing moves.
TEST(AdaptBedLoad, GrainsStayWhereTheLawIsZero) {
  Grains of = test::sand();
  of.adaptation = BedLoadAdaptation::saltation;
  GrainColumns bed = bed_of(40, 1, 0.01);
  const double before = bed.total();
  std::vector<BedStress> stress(40);
  for (int c = 0; c < 40; ++c) {
    const double shields = c < 20 ? 0.2 : 0.02;
    stress[GrainColumns::at(c)] = bed_stress_of(of, std::sqrt(shields * 1.65 * 9.81 * 0.001), 1, 0);
  }
  advance_bed(bed, of, stress, {}, 10, 0.001);
  EXPECT_GT(bed.level(20), 0.0505);
  EXPECT_NEAR(bed.level(30), 0.05, 1e-15);
  // The first column sends what a way of 10 mm makes of such a jump; the quiet one stops what 0.2 m made.
  const double jump = saltation_length(0.2, 0.047, of.size_number(), 0.001);
  const double ratio = (1 - std::exp(-0.01 / jump)) / (1 - std::exp(-0.2 / jump));
  EXPECT_NEAR((0.05 - bed.level(0)) / (bed.level(20) - 0.05), ratio, 0.15 * ratio);  // the heap's slope slows the last
  EXPECT_LT(bed.level(10), 0.05);
  EXPECT_NEAR(bed.total(), before, 1e-12 * before);
}

// Grains that go around in a ring come to the law's rate too.
TEST(AdaptBedLoad, EddiesConverge) {
  const GrainColumns bed = bed_of(2, 2, 0.01);
  // 0 -> 1 -> 3 -> 2 -> 0
  const std::vector<BedPassage> passages = {{0, 1, 1e-7}, {1, 3, 2e-7}, {3, 2, 1e-7}, {2, 0, 2e-7}};
  const auto share = share_of_law(
      bed, passages, [](int) { return length; }, [](int) { return 0.01; });
  const double kept = std::exp(-0.01 / length);
  // Rates a and b of the slow and the fast columns: a = k b + (1 - k), b = k a + 2 (1 - k).
  const double slow = (1 + 2 * kept) / (1 + kept);
  const double fast = (2 + kept) / (1 + kept);
  EXPECT_NEAR(share[0], slow, 1e-10);
  EXPECT_NEAR(share[1], fast / 2, 1e-10);
  EXPECT_NEAR(share[3], slow, 1e-10);
  EXPECT_NEAR(share[2], fast / 2, 1e-10);
}

}  // namespace
}  // namespace thalweg
