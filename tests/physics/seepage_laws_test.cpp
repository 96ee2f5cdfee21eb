#include <gtest/gtest.h>

#include <cmath>

#include "physics/kernel.hpp"
#include "physics/seepage/consolidation.hpp"
#include "physics/seepage/ergun.hpp"
#include "physics/seepage/skeleton.hpp"

namespace thalweg {
namespace {

constexpr double mu = 1e-3;
constexpr double rho = 1000;
constexpr double g = 9.81;

TEST(Ergun, GivesTheFilterVelocitiesOfThePvcBed) {
  // d = 3.5 mm, n = 0.45. n rho g i = 8231 w + 275000 w^2, e.g. i = 0.1: w = 27.8 mm/s, n w = 12.5 mm/s.
  const auto filter = [](double i) { return 0.45 * steady_slip(0.45, 3.5e-3, rho * g * i, mu, rho); };
  EXPECT_NEAR(filter(0.1), 0.0125, 5e-5);
  EXPECT_NEAR(filter(0.5), 0.0341, 5e-5);
  EXPECT_NEAR(filter(1), 0.0507, 5e-5);
  EXPECT_EQ(filter(0), 0);
}

TEST(Ergun, SolvesItsQuadratic) {
  for (const double force : {1.0, 1e3, 1e5}) {
    const double n = 0.4, d = 1e-3;
    const double a = 150 * mu * std::pow(1 - n, 2) / (n * d * d), b = 1.75 * rho * (1 - n) / d;
    EXPECT_NEAR(steady_slip(n, d, force, mu, rho) / ((-a + std::sqrt(a * a + 4 * b * n * force)) / (2 * b)), 1, 1e-8);
  }
}

TEST(Permeability, HasTheHandWorkedValues) {
  const double k = permeability(0.45, 3.5e-3);
  EXPECT_NEAR(k, 2.46e-8, 5e-11);
  EXPECT_NEAR(hydraulic_conductivity(k, rho, mu, g), 0.241, 5e-4);
  // Creeping flow through Ergun's law is Darcy's: n w = k F / mu.
  EXPECT_NEAR(0.45 * steady_slip(0.45, 1e-5, 10.0, mu, rho) / (permeability(0.45, 1e-5) * 10.0 / mu), 1, 1e-6);
}

TEST(WenYu, IsStokesForOneSlowGrainAndNewtonForAFastOne) {
  EXPECT_DOUBLE_EQ(wen_yu_drag(1.0, 1e-4, 0.0, mu, rho), 18 * mu / 1e-8);
  // (3/4) 0.44 rho w/d, Re = 10000.
  EXPECT_NEAR(wen_yu_drag(1.0, 0.01, 1.0, mu, rho), 0.75 * 0.44 * rho * 1.0 / 0.01, 1e-6);
  // The two branches of C_D at Re = 1000: 0.4384 and 0.44.
  EXPECT_NEAR(wen_yu_drag(1.0, 0.01, 0.1001, mu, rho) / wen_yu_drag(1.0, 0.01, 0.0999, mu, rho), 1, 6e-3);
}

TEST(WenYu, SettlesAfterRichardsonAndZaki) {
  // v_s = n w of a suspension, over that of one grain: n^4.65 creeping, n^2.325 turbulent.
  const auto ratio = [](double n, double d, double excess_density) {
    const auto fall = [&](double at) { return at * steady_slip(at, d, (1 - at) * excess_density * g, mu, rho); };
    return std::log(fall(n) / fall(1 - 1e-9)) / std::log(n);
  };
  EXPECT_NEAR(ratio(0.9, 2e-6, 1650), 4.65, 1e-3);
  EXPECT_NEAR(ratio(0.9, 0.05, 1650), 2.325, 1e-3);
}

TEST(Consolidation, HasTheHandWorkedCoefficient) {
  EXPECT_NEAR(consolidation_coefficient(1e-6, 1e6, 9810.0), 1.019e-4, 1e-7);
}

TEST(Consolidation, TakesAsManyStagesAsTheStepNeeds) {
  EXPECT_EQ(legendre_stages(0.3), 1);
  EXPECT_EQ(legendre_stages(1), 1);
  EXPECT_EQ(legendre_stages(3), 2);
  EXPECT_EQ(legendre_stages(3.1), 3);
  EXPECT_EQ(legendre_stages(430), 29);  // 29 * 30 / 2 = 435
}

TEST(Skeleton, IsCompressedByItsOwnWeightAsWaterIs) {
  const double stiffness = skeleton_stiffness(0.55, 1540.0, rho, 20.0);
  EXPECT_NEAR(stiffness, 118800, 1e-6);  // 0.55 * 540 * 400
  const double weight = 0.55 * 540 * g;  // [N/m^3] of the grains under water
  EXPECT_NEAR(weight / stiffness, g / 400, 1e-15);
}

/// Share of the kernel more than x above a particle, by midpoints on a grid of h/200.
double share_above(double x) {
  const WendlandC2<2, double> kernel(1.0);
  constexpr int n = 400;
  const double cell = 2.0 / n;
  double share = 0;
  for (int i = 0; i < n; ++i) {
    const double z = (i + 0.5) * cell;
    if (z < x) continue;
    for (int j = 0; j < 2 * n; ++j) share += kernel.value(kernel.closeness(std::hypot(-2 + (j + 0.5) * cell, z)));
  }
  return share * cell * cell;
}

TEST(Consolidation, KnowsTheDepthBelowAPlaneSurface) {
  EXPECT_NEAR(share_above(0), 0.5, 1e-3);
  for (const double x : {0.2, 0.33, 0.5, 0.65}) EXPECT_NEAR(depth_below_surface(share_above(x)), x, 0.04);
  EXPECT_EQ(depth_below_surface(0.9), 0.1);
  EXPECT_NEAR(share_above(0.7), double(least_share_above), 5e-3);
}

}  // namespace
}  // namespace thalweg
