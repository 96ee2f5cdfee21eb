#include "physics/transport/suspended_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/transport/rouse.hpp"

namespace thalweg {
namespace {

TEST(SuspendedLoadLaw, GrainsSinkSlowerAmongOthers) {
  // 0.9^4.65 = 0.61268, 0.7^4.65 = 0.19042; without the last 40th of the exponent 0.61429 and 0.19213.
  EXPECT_NEAR(hindered_share(0.1), 0.61268, 0.002);
  EXPECT_NEAR(hindered_share(0.3), 0.19042, 0.002);
  EXPECT_EQ(hindered_share(0.0), 1);
  EXPECT_EQ(hindered_share(1.5), 0);
  EXPECT_EQ(hindered_share(-0.1), 1);
}

TEST(SuspendedLoadLaw, TheMeanDiffusivityIsTheLogarithmicOne) {
  EXPECT_NEAR(mean_diffusivity(1.0, 5.0), 4 / std::log(5.0), 0.006);
  EXPECT_NEAR(mean_diffusivity(2.0, 2.0), 2, 1e-6);
  EXPECT_EQ(mean_diffusivity(0.0, 0.0), 0);
}

// Balance C_b/C_a = exp(-q), b higher than a by q D/w.
TEST(SuspendedLoadLaw, GrainsInBalanceDoNotFlow) {
  const double D = 1e-3;
  for (const double q : {0.01, 0.3, 1.0, 3.0}) {
    const double flow = flux_of_grains(1.0, std::exp(-q), q * D, D);
    EXPECT_NEAR(flow, 0, 0.006 * q * D) << q;
  }
}

TEST(SuspendedLoadLaw, WithoutEddiesGrainsLeaveTheHigherPlaceOnly) {
  EXPECT_EQ(flux_of_grains(0.1, 0.2, 0.003, 0.0), 0.003 * 0.2);    // b is higher
  EXPECT_EQ(flux_of_grains(0.1, 0.2, -0.003, 0.0), -0.003 * 0.1);  // a is
  EXPECT_EQ(flux_of_grains(0.1, 0.2, 0.0, 1e-4), 1e-5);            // level: eddies alone
}

TEST(SuspendedLoadLaw, WhatAGainsBLoses) {
  for (const float s : {-0.02F, -1e-4F, 0.0F, 3e-5F, 0.5F}) {
    EXPECT_EQ(flux_of_grains(0.013F, 0.21F, s, 2e-4F), -flux_of_grains(0.21F, 0.013F, -s, 2e-4F)) << s;
  }
}

// kappa u* = 0.0205 m/s, w = 0.02 m/s: P = 0.97561; (0.001/0.005)^P = 0.208
TEST(SuspendedLoadLaw, RousesProfileNeedsNoFluxFromTheBed) {
  const double P = 0.02 / (0.41 * 0.05);
  EXPECT_NEAR(flux_from_bed(0.1, 0.1 * std::pow(0.2, P), 0.02, 0.05, 0.005, 0.001), 0, 1e-9);
}

TEST(SuspendedLoadLaw, WithoutEddiesABedReceivesWhatSettles) {
  EXPECT_EQ(flux_from_bed(0.3, 0.01, 0.02, 0.0, 0.005, 0.001), -0.02 * 0.01);
  EXPECT_NEAR(flux_from_bed(0.3, 0.01, 0.02, 1e-3, 0.005, 0.001), -0.02 * 0.01, 1e-15);
}

// At half of the depth of 0.1 m: C = C_r ((h - z)/z a/h)^P
TEST(SuspendedLoadLaw, RousesProfileNeedsNoFluxWhereTheDepthIsKnown) {
  const double P = 0.02 / (0.41 * 0.05);
  EXPECT_NEAR(flux_from_bed(0.1, 0.1 * std::pow(0.5 * 0.001 / 0.05, P), 0.02, 0.05, 0.05, 0.001, 0.5), 0, 1e-9);
}

// P = 0.018/(0.41 x 0.044) = 0.99778; half the depth over a twentieth: (1 x 1/19)^P.
TEST(RousesProfile, IsOneAtTheReferenceAndZeroAtTheSurface) {
  EXPECT_NEAR(rouse_share(0.05, 0.005, 0.1, 0.044, 0.018), std::pow(1.0 / 19, 0.018 / (0.41 * 0.044)), 1e-12);
  EXPECT_NEAR(rouse_share(0.05, 0.005, 0.1, 0.044, 0.018), 0.052976, 1e-6);
  EXPECT_EQ(rouse_share(0.002, 0.005, 0.1, 0.044, 0.018), 1);
  EXPECT_EQ(rouse_share(0.1, 0.005, 0.1, 0.044, 0.018), 0);
  EXPECT_EQ(rouse_share(0.05, 0.005, 0.1, 0.0, 0.018), 0);
}

// w -> 0: kappa u* (C_r - C)/ln(z/a) = 0.0205 * 0.09/ln 5
TEST(SuspendedLoadLaw, StrongEddiesMixDownTheDifference) {
  EXPECT_NEAR(flux_from_bed(0.1, 0.01, 1e-9, 0.05, 0.005, 0.001), 0.0205 * 0.09 / std::log(5.0), 1e-9);
}

}  // namespace
}  // namespace thalweg
