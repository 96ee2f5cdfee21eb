#include "physics/transport/wall_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

constexpr double nu = 1e-6;

TEST(WallFrictionVelocity, SatisfiesTheLogLawWithBothOrigins) {
  for (const double ks : {0.0, 1e-4, 1e-3, 3.5e-3}) {
    for (const double U : {0.05, 0.3, 1.0, 3.0}) {
      const double z = 5e-3;
      const double u = wall_friction_velocity(U, z, z, nu, ks);
      EXPECT_NEAR(u / 0.41 * std::log(z / (0.11 * nu / u + 0.033 * ks)), U, 1e-6 * U) << U << " m/s, ks " << ks;
    }
  }
}

TEST(WallFrictionVelocity, IsTheSublayersBelowElevenPointThreeWallUnits) {
  // u* = 1 mm/s, z+ = 5: U = u*^2 z/nu = 5 mm/s at z = 5 mm. Above it the log law is the larger of the two.
  EXPECT_NEAR(wall_friction_velocity(5e-3, 5e-3, 5e-3, nu, 0.0), 1e-3, 1e-12);
  // At the crossing ln(11.3/0.11)/0.41 = 11.298, so that both give u* within a thousandth.
  const double z = 11.3 * nu / 1e-3;
  EXPECT_NEAR(wall_friction_velocity(11.298e-3, z, z, nu, 0.0), 1e-3, 1e-6);
}

TEST(WallFrictionVelocity, HasNoStepInRoughness) {
  // From smooth to fully rough in steps of one percent of ks: u* follows in steps below one percent.
  double last = wall_friction_velocity(0.5, 5e-3, 5e-3, nu, 0.0);
  for (double ks = 1e-6; ks < 5e-3; ks *= 1.01) {
    const double u = wall_friction_velocity(0.5, 5e-3, 5e-3, nu, ks);
    EXPECT_GE(u, last);
    EXPECT_LT(u, 1.01 * last);
    last = u;
  }
}

TEST(WallFrictionVelocity, IsBoundedAmongTheRoughnessElements) {
  EXPECT_DOUBLE_EQ(wall_friction_velocity(1.0, 1e-3, 1e-3, nu, 0.1), 0.41);
  EXPECT_EQ(wall_friction_velocity(0.0, 1e-3, 1e-3, nu, 0.1), 0);
}

TEST(LogMeanHeight, IsTheHeightOfTheMeanLogarithm) {
  // Layers at 0.5, 1.5 and 2.5 dp with the weights that a lattice of h/dp = 2 gives them.
  const double weights[] = {0.797, 0.183, 0.020};
  double mean = 0;
  double square = 0;
  double logarithm = 0;
  for (int k = 0; k < 3; ++k) {
    mean += weights[k] * (k + 0.5);
    square += weights[k] * (k + 0.5) * (k + 0.5);
    logarithm += weights[k] * std::log(k + 0.5);
  }
  EXPECT_NEAR(log_mean_height(mean, square - mean * mean), std::exp(logarithm), 0.02 * mean);
  EXPECT_DOUBLE_EQ(log_mean_height(mean, 100 * mean * mean), mean * std::exp(-0.5));
}

}  // namespace
}  // namespace thalweg
