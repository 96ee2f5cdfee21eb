#include "physics/transport/bed_shear.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/transport/critical_shields.hpp"
#include "physics/transport/friction_velocity.hpp"

namespace thalweg {
namespace {

constexpr double nu = 1e-6;             // m^2/s, water
constexpr double ks = 0.0035;           // m, grains of the paper's case
constexpr double pvc_weight = 18.5409;  // Pa, (1540 - 1000) 9.81 0.0035

TEST(CriticalShields, HasTheValuesOfItsFormula) {
  EXPECT_NEAR(critical_shields_number(10.4), 0.0381, 1e-4);
  EXPECT_NEAR(critical_shields_number(100.0), 0.0526, 5e-5);
  EXPECT_NEAR(critical_shields_number(500.0), 0.0688, 5e-5);
  EXPECT_EQ(critical_shields_number(500.1), 0.068);
  EXPECT_EQ(critical_shields_number(1e9), 0.068);
  EXPECT_EQ(critical_shields_number(1.0), 0.1);
  EXPECT_EQ(critical_shields_number(0.0), 0.1);
}

TEST(CriticalShields, IsSmallestWhereItShouldBe) {
  double lowest = 1;
  double at = 0;
  for (double r = 1.01; r < 500; r += 0.01) {
    if (critical_shields_number(r) < lowest) {
      lowest = critical_shields_number(r);
      at = r;
    }
  }
  EXPECT_NEAR(at, 10.4, 0.05);  // derivative zero at 0.110476/0.010595 = 10.427
  EXPECT_NEAR(lowest, 0.03815, 5e-6);
}

TEST(FrictionVelocity, HasTheHandWorkedValues) {
  const auto slow = friction_velocity(0.6, 0.002, nu, ks);
  EXPECT_NEAR(slow.friction_velocity, 0.0863, 5e-5);
  EXPECT_LE(slow.iterations, 3);
  EXPECT_NEAR(bed_shear_stress(1000.0, slow.friction_velocity), 7.44, 5e-3);
  EXPECT_NEAR(shields_number(bed_shear_stress(1000.0, slow.friction_velocity), pvc_weight), 0.401, 5e-4);

  const auto fast = friction_velocity(1.0, 0.004, nu, ks);
  EXPECT_NEAR(fast.friction_velocity, 0.1157, 5e-5);
  EXPECT_LE(fast.iterations, 3);
  EXPECT_NEAR(bed_shear_stress(1000.0, fast.friction_velocity), 13.4, 0.05);
  EXPECT_NEAR(shields_number(bed_shear_stress(1000.0, fast.friction_velocity), pvc_weight), 0.722, 5e-4);
}

TEST(FrictionVelocity, IsTheSublayersBelowAndTheLogLawsAbove) {
  // Viscous sublayer: tau = mu U/z, here u* = sqrt(0.01 1e-6/0.0002) = 0.00707 and z+ = 1.41.
  EXPECT_NEAR(friction_velocity(0.01, 0.0002, nu, 0.0).friction_velocity, std::sqrt(5e-5), 1e-15);
  EXPECT_EQ(friction_velocity(0.01, 0.0002, nu, 0.0).iterations, 0);
  // Smooth wall, z+ = 1000: U/u* = ln(1000/0.11)/0.41.
  const double smooth = 0.01;
  const double U = smooth / 0.41 * std::log(1000 / 0.11);
  EXPECT_NEAR(friction_velocity(U, 1000 * nu / smooth, nu, 0.0).friction_velocity / smooth, 1, 1e-3);
  // Rough wall, ks+ = 350, twenty roughness heights above it: U/u* = ln(20/0.033)/0.41, exactly after one round.
  EXPECT_NEAR(friction_velocity(0.1 / 0.41 * std::log(20 / 0.033), 0.07, nu, ks).friction_velocity, 0.1, 1e-12);
}

TEST(FrictionVelocity, KeepsItsEquationInEveryRegime) {
  // The result satisfies its branch to the tolerance of the iteration, or to the step of z0 at ks+ = 70.
  for (double speed = 1e-4; speed < 30; speed *= 1.7) {
    for (double z = 1e-5; z < 0.5; z *= 1.9) {
      for (const double roughness : {0.0, 1e-5, 2e-4, 0.0035, 0.05}) {
        const auto found = friction_velocity(speed, z, nu, roughness);
        const double u = found.friction_velocity;
        const double laminar = std::sqrt(speed * nu / z);
        if (std::fabs(u / laminar - 1) < 1e-12) {
          EXPECT_LE(u * z / nu, 11.6) << speed << ' ' << z << ' ' << roughness;
          continue;
        }
        const double log_height = std::fmax(1, std::log(z / log_law_origin(u, nu, roughness)));
        const bool on_the_step = found.iterations == most_friction_iterations;
        if (on_the_step) {
          EXPECT_NEAR(u * roughness / nu, 70, 3) << speed << ' ' << z << ' ' << roughness;
        }
        EXPECT_NEAR(u * log_height / 0.41 / speed, 1, on_the_step ? 0.03 : 2e-3) << z << ' ' << roughness;
      }
    }
  }
}

TEST(FrictionVelocity, StaysBoundedAmongTheRoughness) {
  EXPECT_EQ(friction_velocity(0.0, 0.002, nu, ks).friction_velocity, 0);
  EXPECT_DOUBLE_EQ(friction_velocity(1.0, 1e-5, nu, ks).friction_velocity, 0.41);  // z below z0
  EXPECT_NEAR(friction_velocity(0.6F, 0.002F, 1e-6F, 0.0035F).friction_velocity, 0.0863F, 5e-5F);
}

TEST(FrictionVelocity, OriginOfTheLogLawHasThreePieces) {
  EXPECT_DOUBLE_EQ(log_law_origin(1e-3, nu, 1e-3), 0.11e-3);            // ks+ = 1
  EXPECT_DOUBLE_EQ(log_law_origin(0.1, nu, 1e-3), 0.033e-3);            // ks+ = 100
  EXPECT_DOUBLE_EQ(log_law_origin(0.02, nu, 1e-3), 5.5e-6 + 0.033e-3);  // ks+ = 20
}

TEST(BedShear, OfThePaperExceedsTheLogLaws) {
  EXPECT_NEAR(bed_shear_stress_of_difference(1000.0, 0.6), 15.1, 0.05);
  EXPECT_NEAR(bed_shear_stress_of_difference(1000.0, 1.0), 42.0, 0.05);
  const double ratio[] = {1.2, 2.0, 3.1, 4.5};
  double z = 0.001;
  for (const double expected : ratio) {
    const double u = friction_velocity(1.0, z, nu, ks).friction_velocity;
    EXPECT_NEAR(bed_shear_stress_of_difference(1000.0, 1.0) / bed_shear_stress(1000.0, u), expected, 0.05) << z;
    z *= 2;
  }
}

TEST(BedShear, MeasuresStressInGrainWeights) {
  EXPECT_NEAR(grain_weight_stress(1540.0, 1000.0, 9.81, 0.0035), pvc_weight, 1e-10);
  EXPECT_NEAR(critical_stress_of_flat_bed(0.06, pvc_weight), 1.11, 5e-3);
  EXPECT_DOUBLE_EQ(shields_number(critical_stress_of_flat_bed(0.06, pvc_weight), pvc_weight), 0.06);
}

}  // namespace
}  // namespace thalweg
