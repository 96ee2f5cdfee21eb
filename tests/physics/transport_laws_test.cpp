#include <gtest/gtest.h>

#include <cmath>

#include "physics/transport/bed_load.hpp"
#include "physics/transport/bed_load_drift.hpp"
#include "physics/transport/lift_settling.hpp"
#include "physics/transport/pick_up.hpp"
#include "physics/transport/saltation_length.hpp"
#include "physics/transport/slope_effect.hpp"

namespace thalweg {
namespace {

constexpr double d = 0.0035;  // m, the paper's PVC grains, 1540 kg/m^3

// sqrt(0.54 * 9.81 * 4.2875e-8) = sqrt(2.27126e-7) = 4.76577e-4 m^2/s
TEST(BedLoad, HasTheHandWorkedUnit) { EXPECT_NEAR(bed_load_scale(d, 1540.0, 1000.0, 9.81), 4.76577e-4, 1e-9); }

// 8 * 0.353^1.5 = 8 * 0.2097307 = 1.677846
TEST(BedLoad, FollowsMeyerPeterAndMueller) {
  EXPECT_NEAR(meyer_peter_mueller(0.4, 0.047), 1.677846, 1e-6);
  EXPECT_EQ(meyer_peter_mueller(0.047, 0.047), 0);
  EXPECT_EQ(meyer_peter_mueller(0.01, 0.047), 0);
  EXPECT_NEAR(meyer_peter_mueller(0.4F, 0.047F), 1.677846F, 1e-5F);
  EXPECT_NEAR(meyer_peter_mueller(0.447, 0.047) / meyer_peter_mueller(0.147, 0.047), 8, 1e-9);  // 4^1.5
}

// 3.97 * 0.3505^1.5 = 3.97 * 0.207508 = 0.823801
TEST(BedLoad, FollowsWongAndParker) {
  EXPECT_NEAR(wong_parker(0.4, 0.0495), 0.823801, 1e-6);
  EXPECT_EQ(wong_parker(0.0495, 0.0495), 0);
}

// (pi/6) 0.51/0.35 = 0.762967, p = 1.338863^(-1/4) = 0.929645; 5 p (0.632456 - 0.156525) = 2.212234
TEST(BedLoad, FollowsEngelundAndFredsoe) {
  EXPECT_NEAR(engelund_fredsoe(0.4, 0.05), 2.212234, 1e-5);
  EXPECT_EQ(engelund_fredsoe(0.05, 0.05), 0);
  EXPECT_GT(engelund_fredsoe(0.0501, 0.05), 0);
}

TEST(BedLoad, IsThatOfTheLawChosen) {
  EXPECT_EQ(bed_load(BedLoad::meyer_peter_mueller, 0.4, 0.05, 61.01), meyer_peter_mueller(0.4, 0.05));
  EXPECT_EQ(bed_load(BedLoad::wong_parker, 0.4, 0.05, 61.01), wong_parker(0.4, 0.05));
  EXPECT_EQ(bed_load(BedLoad::engelund_fredsoe, 0.4, 0.05, 61.01), engelund_fredsoe(0.4, 0.05));
  EXPECT_EQ(bed_load(BedLoad::van_rijn, 0.4, 0.05, 61.01), van_rijn_bed_load(0.4, 0.05, 61.01));
}

TEST(BedLoadDrift, CarriesTheFluxInALayerOfOneSpacing) {
  // 6e-5 m^2/s in (1 - 0.4) 5 mm: 0.02 m/s; never faster than the water.
  EXPECT_NEAR(bed_load_drift(6e-5, 0.6 * 0.005, 1.0), 0.02, 1e-12);
  EXPECT_EQ(bed_load_drift(6e-5, 0.6 * 0.005, 0.01), 0.01);
}

TEST(BedLoadDrift, FrictionHalvesItUpTheAngleOfReposeAndMakesItThreefoldDownTwoThirdsOfIt) {
  EXPECT_EQ(bed_load_slope_factor(SlopeEffect::friction, 0.0, 0.625), 1);
  EXPECT_EQ(bed_load_slope_factor(SlopeEffect::friction, 0.625, 0.625), 0.5);
  EXPECT_NEAR(bed_load_slope_factor(SlopeEffect::friction, -0.5 * 0.625, 0.625), 2, 1e-12);
  EXPECT_NEAR(bed_load_slope_factor(SlopeEffect::friction, -2.0, 0.625), 1 / 0.33, 1e-12);  // held there
}

// 1.5 sqrt(1/4)
TEST(BedLoadDrift, LeansDownASlopeAcrossTheFlow) { EXPECT_EQ(transverse_slope(0.25), 0.75); }

// 0.053 * 7^2.1/61.01^0.3 = 0.053 * 59.5259/3.4326 = 0.919097
TEST(BedLoad, FollowsVanRijn) {
  EXPECT_NEAR(van_rijn_bed_load(0.4, 0.05, 61.01), 0.919097, 1e-6);
  EXPECT_EQ(van_rijn_bed_load(0.05, 0.05, 61.01), 0);
}

// 3 * 0.8 mm * 20.24^0.6 * 9^0.9 = 2.4e-3 * 6.0777 * 7.2247 = 0.10538 m
TEST(BedLoad, JumpsAsVanRijnMeasured) {
  EXPECT_NEAR(saltation_length(0.3, 0.03, 20.24, 0.0008), 0.105379, 1e-6);
  EXPECT_EQ(saltation_length(0.03, 0.03, 20.24, 0.0008), 0);
}

// 0.00033 * 61.01^0.3 * 7^1.5 * sqrt(0.54 * 9.81 * 0.0035) = 0.00033 * 3.4326 * 18.5203 * 0.136165 = 2.85658e-3 m/s
TEST(PickUp, FollowsVanRijn) {
  EXPECT_NEAR(van_rijn_pick_up(0.4, 0.05, 61.01, d, 1540.0, 1000.0, 9.81), 2.85658e-3, 1e-8);
  EXPECT_EQ(van_rijn_pick_up(0.05, 0.05, 61.01, d, 1540.0, 1000.0, 9.81), 0);
}

// Both are a power of 1.5 of the excess: equal where 0.00033/theta_cr^1.5 = 0.018.
TEST(PickUp, AgreesWithMastbergenAtOneCriticalShieldsNumber) {
  const double critical = std::pow(0.00033 / 0.018, 2.0 / 3);
  EXPECT_NEAR(van_rijn_pick_up(0.5, critical, 61.01, d, 1540.0, 1000.0, 9.81) /
                  lift_velocity(0.5, critical, 61.01, d, 1540.0, 1000.0, 9.81),
              1, 1e-12);
}

// (1e-6/0.0035) (sqrt(107.3296 + 1.049 * 0.9^4.7 * 61.013^3) - 10.36) = 0.105954 m/s
TEST(HinderedSettling, SlowsWithTheShareOfGrains) {
  const double d_star = dimensionless_diameter(d, 1540.0, 1000.0, 9.81, 1e-3);
  EXPECT_NEAR(hindered_settling_velocity(d_star, 0.1, d, 1e-6), 0.105954, 1e-6);
  EXPECT_EQ(hindered_settling_velocity(d_star, 0.0, d, 1e-6), settling_velocity(d_star, d, 1e-6));
  EXPECT_EQ(hindered_settling_velocity(d_star, 1.0, d, 1e-6), 0);
  EXPECT_EQ(hindered_settling_velocity(d_star, -0.1, d, 1e-6), settling_velocity(d_star, d, 1e-6));
}

}  // namespace
}  // namespace thalweg
