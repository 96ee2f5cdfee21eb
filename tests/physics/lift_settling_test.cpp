#include "physics/transport/lift_settling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thalweg {
namespace {

constexpr double d = 0.0035;  // m, the paper's PVC grains, 1540 kg/m^3

TEST(LiftSettling, HasTheHandWorkedValuesOfThePapersGrains) {
  const double d_star = dimensionless_diameter(d, 1540.0, 1000.0, 9.81, 1e-3);
  EXPECT_NEAR(d_star, 61.01, 5e-3);
  EXPECT_NEAR(settling_velocity(d_star, d, 1e-6), 0.1365, 5e-5);
  const auto lift = [&](double excess) { return lift_velocity(0.05 + excess, 0.05, d_star, d, 1540.0, 1000.0, 9.81); };
  EXPECT_NEAR(lift(1), 0.00841, 5e-6);
  EXPECT_NEAR(lift(4) / lift(1), 8, 1e-12);  // power 1.5
  EXPECT_NEAR(lift(0.6 - 0.06), 0.0033, 5e-5);
  EXPECT_NEAR(lift(4 - 0.06), 0.066, 5e-4);
}

TEST(LiftSettling, LiftsNothingBelowTheCriticalShieldsNumber) {
  EXPECT_EQ(lift_velocity(0.05, 0.05, 61.0, d, 1540.0, 1000.0, 9.81), 0);
  EXPECT_EQ(lift_velocity(0.01, 0.05, 61.0, d, 1540.0, 1000.0, 9.81), 0);
}

TEST(LiftSettling, SettlesWithTheLimitsOfSoulsbysFormula) {
  // Small grains: nu d*^3 1.049/(2 * 10.36 d); the difference of roots alone would keep no digit of it in float.
  const double small = 0.01;
  EXPECT_NEAR(settling_velocity(small, 1e-5, 1e-6) / (0.1 * 1.049 * small * small * small / 20.72), 1, 1e-6);
  EXPECT_NEAR(settling_velocity(0.01F, 1e-5F, 1e-6F) / settling_velocity(0.01, 1e-5, 1e-6), 1, 1e-5);
  // Large grains: sqrt(1.049 d*^3) nu/d = sqrt(1.049 (s - 1) g d), independent of viscosity.
  const double D = 0.1;
  const double d_star = dimensionless_diameter(D, 2650.0, 1000.0, 9.81, 1e-3);
  EXPECT_NEAR(settling_velocity(d_star, D, 1e-6) / std::sqrt(1.049 * 1.65 * 9.81 * D), 1, 0.01);
  // The formula as printed.
  EXPECT_NEAR(settling_velocity(5.0, 2e-4, 1e-6), 1e-6 / 2e-4 * (std::sqrt(10.36 * 10.36 + 1.049 * 125) - 10.36),
              1e-15);
}

}  // namespace
}  // namespace thalweg
