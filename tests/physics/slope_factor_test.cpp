#include "physics/transport/slope_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/physics/degree.hpp"

namespace thalweg {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
const V3 down{0, 0, -1};

double length(const V3& v) { return std::sqrt(dot(v, v)); }

/// Drag over weight at which a grain slides, by bisection of the balance of forces as they stand in the paper's
/// (25)-(28): the tangential force grows, the normal one shrinks to 0 with the drag.
double drag_by_bisection(const V3& normal, const V3& along, const V3& gravity, double t, double eta) {
  const auto excess = [&](double drag) {
    const double on_the_bed = -dot(gravity, normal) - eta * drag;  // W.n less the lift
    const V3 sliding = gravity - dot(gravity, normal) * normal + drag * along;
    return length(sliding) - t * on_the_bed;
  };
  double holds = 0;
  double slides = 10;
  for (int k = 0; k < 200; ++k) {
    const double middle = (holds + slides) / 2;
    (excess(middle) < 0 ? holds : slides) = middle;
  }
  return (holds + slides) / 2;
}

TEST(SlopeFactor, HasTheHandWorkedValues) {
  const double t = std::tan(38 * degree);
  const auto k = [&](double slope, const V3& flow) {
    const V3 normal{std::sin(slope * degree), 0, std::cos(slope * degree)};  // falls towards +x
    return slope_factor(normal, flow, down, t, 0.85);
  };
  EXPECT_DOUBLE_EQ(k(0, {1, 0, 0}), 1);
  EXPECT_NEAR(k(20, {1, 0, 0}), 0.501927, 5e-7);
  EXPECT_NEAR(k(20, {-1, 0, 0}), 1.377458, 5e-7);
  EXPECT_NEAR(k(20, {0, 1, 0}), 0.7645225, 5e-7);
  EXPECT_NEAR(k(20, {0, -7, 0}), 0.7645225, 5e-7);
  EXPECT_NEAR(k(38, {1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(k(38, {0, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(k(37.999999, {-1, 0, 0}), 2 * std::cos(38 * degree), 1e-6);
}

TEST(SlopeFactor, AlongTheFlowIsSineOfSumWhateverTheLift) {
  const double phi = 35 * degree;
  for (const double eta : {0.0, 0.5, 0.85, 1.2}) {
    for (double b = 1; b < 35; b += 3) {
      const V2 normal{std::sin(b * degree), std::cos(b * degree)};
      EXPECT_NEAR(slope_factor(normal, V2{1, 0}, V2{0, -1}, std::tan(phi), eta),
                  std::sin(phi - b * degree) / std::sin(phi), 1e-13);
      EXPECT_NEAR(slope_factor(normal, V2{-1, 0}, V2{0, -1}, std::tan(phi), eta),
                  std::sin(phi + b * degree) / std::sin(phi), 1e-13);
    }
  }
}

TEST(SlopeFactor, AcrossTheFlowIsLanesAndItsExtensionByLift) {
  const double t = std::tan(38 * degree);
  for (const double eta : {0.0, 0.3, 0.85}) {
    const double D = eta * t;
    for (double b = 0; b < 38; b += 4) {
      const double tan_b = std::tan(b * degree);
      const double expected =
          std::cos(b * degree) * (std::sqrt(1 - (1 - D * D) * tan_b * tan_b / (t * t)) - D) / (1 - D);
      const V3 normal{std::sin(b * degree), 0, std::cos(b * degree)};
      EXPECT_NEAR(slope_factor(normal, V3{0, 1, 0}, down, t, eta), expected, 1e-13);
    }
  }
}

TEST(SlopeFactor, IsTheBalanceOfForcesOnRandomSlopes) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> share(0, 1);
  double worst = 0;
  for (int n = 0; n < 20000; ++n) {
    const double phi = (5 + 50 * share(random)) * degree;
    const double t = std::tan(phi);
    const double eta = std::fmin(0.98 / t, 1.2 * share(random));
    const double slope = phi * share(random);
    const double turn = 360 * degree * share(random);
    const V3 normal{std::sin(slope) * std::cos(turn), std::sin(slope) * std::sin(turn), std::cos(slope)};
    const V3 flow{gauss(random), gauss(random), gauss(random)};  // with a part into the bed, which must not count
    V3 along = flow - dot(flow, normal) * normal;
    along = (1 / length(along)) * along;

    const double flat = drag_by_bisection({0, 0, 1}, {1, 0, 0}, down, t, eta);
    const double brute = drag_by_bisection(normal, along, down, t, eta) / flat;
    worst = std::fmax(worst, std::fabs(slope_factor(normal, flow, down, t, eta) - std::fmin(brute, 2)));
  }
  EXPECT_LT(worst, 1e-10);
}

TEST(SlopeFactor, KnowsNoDirectionButGravitys) {
  // The same slope and flow, all turned together.
  const double t = std::tan(38 * degree);
  const auto turned = [](const V3& v) {
    const double c = std::cos(1.1);
    const double s = std::sin(1.1);
    const V3 about_y{c * v[0] + s * v[2], v[1], -s * v[0] + c * v[2]};
    return V3{c * about_y[0] - s * about_y[1], s * about_y[0] + c * about_y[1], about_y[2]};
  };
  const V3 normal{std::sin(0.3), 0, std::cos(0.3)};
  const V3 flow{0.4, -0.2, 0.1};
  EXPECT_NEAR(slope_factor(turned(normal), turned(flow), turned(down), t, 0.85),
              slope_factor(normal, flow, down, t, 0.85), 1e-13);
}

TEST(SlopeFactor, IsZeroFromTheAngleOfReposeOnAndFiniteEverywhere) {
  const double t = std::tan(38 * degree);
  for (const double slope : {38.0001, 45.0, 89.0, 90.0, 135.0, 180.0}) {
    const V3 normal{std::sin(slope * degree), 0, std::cos(slope * degree)};
    EXPECT_EQ(slope_factor(normal, V3{1, 0, 0}, down, t, 0.85), 0) << slope;
    EXPECT_EQ(slope_factor(normal, V3{-1, 0, 0}, down, t, 0.85), 0) << slope;
  }
  // No flow, or flow straight at the bed: as across the slope.
  const V3 normal{std::sin(0.3), 0, std::cos(0.3)};
  const double across = slope_factor(normal, V3{0, 1, 0}, down, t, 0.85);
  EXPECT_EQ(slope_factor(normal, V3{0, 0, 0}, down, t, 0.85), across);
  // Lift above which a flat bed would rise: phi = 55 deg, eta = 0.85 has eta tan(phi) = 1.21.
  for (double slope = 0; slope < 55; slope += 5) {
    for (double turn = 0; turn < 360; turn += 30) {
      const V3 n{std::sin(slope * degree), 0, std::cos(slope * degree)};
      const V3 flow{std::cos(turn * degree), std::sin(turn * degree), 0};
      const double k = slope_factor(n, flow, down, std::tan(55 * degree), 0.85);
      EXPECT_GE(k, 0);
      EXPECT_LE(k, 2);
    }
  }
}

TEST(SlopeFactor, HoldsInSinglePrecision) {
  const float b = 0.3F;
  const Vec<3, float> normal{std::sin(b), 0, std::cos(b)};
  const V3 normal_d{std::sin(double(b)), 0, std::cos(double(b))};
  const double t = std::tan(38 * degree);
  EXPECT_NEAR(slope_factor(normal, Vec<3, float>{1, 0.5F, 0}, Vec<3, float>{0, 0, -1}, float(t), 0.85F),
              slope_factor(normal_d, V3{1, 0.5, 0}, down, t, 0.85), 1e-6);
}

}  // namespace
}  // namespace thalweg
