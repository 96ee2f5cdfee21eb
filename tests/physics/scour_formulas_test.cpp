#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "physics/scour/breusers_time.hpp"
#include "physics/scour/dey_sarkar_wall_jet.hpp"
#include "physics/scour/hec18_pier.hpp"
#include "physics/scour/laursen_clear_water.hpp"
#include "physics/scour/laursen_critical_velocity.hpp"
#include "physics/scour/laursen_live_bed.hpp"
#include "physics/scour/mason_arumugam_plunge_pool.hpp"
#include "physics/scour/pier_time_scale.hpp"
#include "physics/scour/pipeline_scour.hpp"
#include "physics/scour/pipeline_time_scale.hpp"
#include "physics/scour/schoklitsch_plunge_pool.hpp"
#include "physics/scour/sheppard_critical_velocity.hpp"
#include "physics/scour/sheppard_melville_pier.hpp"

namespace thalweg {
namespace {

std::string names_of(const std::vector<LimitLeft>& limits) {
  std::string names;
  for (const LimitLeft& left : limits) names += left.name + (left.below ? "<" : ">") + " ";
  return names;
}

const Hec18Pier hec18_example{.width = 1.22, .length = 18, .depth = 3.12, .velocity = 3.36};

// Worked example of HEC-18, 4th edition 2001, in SI units: it rounds Fr to 0.61 and y_s/y1 to 0.97, which makes 3.03
// m. Unrounded: 2 * 1.1 * 3.12 * (1.22/3.12)^0.65 * 0.60733^0.43 = 6.864 * 0.54318 * 0.80697 = 3.0087 m
TEST(Hec18PierScour, GivesTheWorkedExample) {
  EXPECT_NEAR(hec18_pier_equation(hec18_example), 3.0087, 1e-4);
  EXPECT_NEAR(hec18_pier_equation(hec18_example), 3.03, 0.01 * 3.03);
  EXPECT_NEAR(hec18_pier_scour(hec18_example), 2.4 * 1.22, 1e-12);  // the rule of thumb, which the example leaves out
}

// The same at 20 degrees with L/a = 18/1.22 = 14.8, taken as 12: K2 = (0.93969 + 12 * 0.34202)^0.65 = 2.86; HEC-18:
// 8.7 m.
TEST(Hec18PierScour, GrowsWithTheAngleOfAttack) {
  Hec18Pier skewed = hec18_example;
  skewed.nose = PierNose::round;
  skewed.angle = 20 * 0.017453292519943295;
  EXPECT_NEAR(hec18_angle_factor(skewed), 2.8629, 1e-4);
  EXPECT_NEAR(hec18_pier_scour(skewed), 8.7, 0.1);
  EXPECT_EQ(names_of(limits_left(skewed)), "L/a> ");
  skewed.nose = PierNose::circular;
  EXPECT_EQ(hec18_angle_factor(skewed), 1);
}

TEST(Hec18PierScour, KnowsTheShapeOfTheNose) {
  EXPECT_EQ(hec18_nose_factor(PierNose::square, 0), 1.1);
  EXPECT_EQ(hec18_nose_factor(PierNose::sharp, 0), 0.9);
  EXPECT_EQ(hec18_nose_factor(PierNose::round, 0), 1.0);
  EXPECT_EQ(hec18_nose_factor(PierNose::square, 0.2), 1.0);  // 11 degrees
}

TEST(Hec18PierScour, IsAtMostTwoAndAHalfAndThreeWidths) {
  Hec18Pier slender{.width = 0.1, .length = 0.1, .depth = 3, .velocity = 3};  // Fr = 0.55
  EXPECT_NEAR(hec18_pier_scour(slender), 0.24, 1e-12);
  slender.velocity = 6;  // Fr = 1.1
  EXPECT_NEAR(hec18_pier_scour(slender), 0.3, 1e-12);
  slender.nose = PierNose::square;
  EXPECT_GT(hec18_pier_scour(slender), 0.3);  // the bound is for round noses
}

// A formula of Froude's number alone: lengths times 4 and velocities times 2 give four times the depth.
TEST(Hec18PierScour, ScalesAfterFroude) {
  const Hec18Pier larger{.width = 4.88, .length = 72, .depth = 12.48, .velocity = 6.72};
  EXPECT_NEAR(hec18_pier_equation(larger) / hec18_pier_equation(hec18_example), 4, 1e-12);
}

TEST(Hec18PierScour, SaysThatAWidePierInShallowWaterIsOutsideItsRange) {
  EXPECT_EQ(names_of(limits_left(hec18_example)), "");
  const auto left = limits_left(Hec18Pier{.width = 1, .length = 1, .depth = 0.1, .velocity = 0.5});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].name, "y/a");
  EXPECT_EQ(left[0].value, 0.1);
  EXPECT_EQ(left[0].limit, 0.8);
  EXPECT_TRUE(left[0].below);
}

const SheppardMelvillePier at_threshold{
    .effective_width = 1, .depth = 2, .velocity = 0.5, .critical_velocity = 0.5, .grain_diameter = 0.5e-3};

// tanh(2^0.4) = tanh(1.31951) = 0.866662; r = 2000: 2000/(0.4 * 9146.1 + 10.6 * 0.37228) = 0.546092; 2.5 times both:
// 1.18319 m
TEST(SheppardMelvillePierScour, HasTheHandWorkedValueAtTheThreshold) {
  EXPECT_NEAR(sheppard_melville_pier_scour(at_threshold), 1.18319, 1e-5);
  EXPECT_EQ(names_of(limits_left(at_threshold)), "");
}

TEST(SheppardMelvillePierScour, MeetsItselfAtTheThresholdAndAtTheLiveBedPeak) {
  SheppardMelvillePier pier = at_threshold;
  pier.velocity = 0.5 * (1 + 1e-9);
  EXPECT_NEAR(sheppard_melville_pier_scour(pier), sheppard_melville_pier_scour(at_threshold), 1e-8);
  // 0.6 sqrt(9.81 * 2) = 2.6576 m/s, more than 5 V_c = 2.5 m/s
  pier.velocity = 2.657 * 1.001;
  EXPECT_NEAR(sheppard_melville_pier_scour(pier), 2.2 * 0.866662, 1e-5);
  pier.velocity = 2.6575;
  EXPECT_NEAR(sheppard_melville_pier_scour(pier), 2.2 * 0.866662, 1e-3);
}

// f2 at V/V_c = 0.5: 1 - 1.2 * 0.48045 = 0.42346
TEST(SheppardMelvillePierScour, FadesInClearWater) {
  SheppardMelvillePier pier = at_threshold;
  pier.velocity = 0.25;
  EXPECT_NEAR(sheppard_melville_pier_scour(pier) / sheppard_melville_pier_scour(at_threshold), 0.42346, 1e-5);
  pier.velocity = 0.2001;  // f2 would be -0.0064
  EXPECT_EQ(sheppard_melville_pier_scour(pier), 0);
  pier.velocity = 0.19;
  EXPECT_EQ(sheppard_melville_pier_scour(pier), 0);
  EXPECT_EQ(names_of(limits_left(pier)), "V/Vc< ");
}

// Broadside to the flow 0.86 + 0.97 (pi/4)^4 = 1.2291 for a rectangle; across the diagonal 0.86.
TEST(SheppardMelvillePierScour, TakesTheProjectedWidth) {
  EXPECT_EQ(effective_pier_width(PierNose::circular, 1, 1, 0.5), 1);
  EXPECT_NEAR(effective_pier_width(PierNose::square, 1, 4, 0), 1.2291, 1e-4);
  EXPECT_NEAR(effective_pier_width(PierNose::round, 1, 4, 0.5235987755982988), 0.866025 + 2, 1e-6);
}

// 6.19 * 2^(1/6) * 0.1 = 0.69480 m/s. sqrt(0.039 * 1.65)/0.041 = 6.187: the coefficient is Shields' with Strickler's
// n.
TEST(CriticalVelocity, FollowsLaursen) {
  EXPECT_NEAR(laursen_critical_velocity(2, 1e-3, 2.65), 0.69480, 1e-5);
  EXPECT_NEAR(laursen_critical_velocity(1, 1, 2.65), std::sqrt(0.039 * 1.65) / 0.041, 5e-3);
  EXPECT_NEAR(laursen_critical_velocity(2, 1e-3, 1.54) / 0.69480, std::sqrt(0.54 / 1.65), 1e-5);
}

// d* = 1e-3 * (1.65 * 9.81/1e-12)^(1/3) = 25.296; theta_c = 0.0581824 - 0.0308926 + 0.0090924 - 0.005 = 0.031382;
// u* = 0.022538 m/s; R = 56.35, z0 = 0.07788 mm; 2.5 * 0.022538 * ln(1/(2.72 * 7.788e-5)) = 0.4767 m/s
TEST(CriticalVelocity, FollowsTheFloridaManual) {
  EXPECT_NEAR(sheppard_critical_velocity(1, 1e-3, 2.65, 9.81, 1e-6), 0.4767, 1e-4);
  EXPECT_NEAR(sheppard_critical_shields(10), 0.032296, 1e-6);
}

// Both laws are for the same thing: sands in a metre of water within a third of each other, Laursen's the higher.
TEST(CriticalVelocity, IsAlikeByBothLawsInSand) {
  for (const double d : {0.5e-3, 1e-3, 2e-3}) {
    const double ratio = sheppard_critical_velocity(1, d, 2.65, 9.81, 1e-6) / laursen_critical_velocity(1, d, 2.65);
    EXPECT_GT(ratio, 0.67) << d;
    EXPECT_LT(ratio, 1) << d;
  }
}

TEST(CriticalVelocity, HasNoStepBetweenItsPieces) {
  EXPECT_NEAR(sheppard_critical_shields(3 + 1e-9) / sheppard_critical_shields(3), 1, 0.01);
  EXPECT_NEAR(sheppard_critical_shields(150 + 1e-9) / sheppard_critical_shields(150), 1, 0.01);
}

// 2^0.64 = 1.55833; the exponents of HEC-18's table 6.1.
TEST(LaursenContraction, DeepensALiveBedByTheWidths) {
  LaursenLiveBed flow{
      .depth = 2, .width = 40, .contracted_width = 20, .friction_velocity = 0.1, .settling_velocity = 0.1};
  EXPECT_NEAR(laursen_live_bed_depth(flow), 3.11666, 1e-5);
  flow.settling_velocity = 1;
  EXPECT_NEAR(laursen_live_bed_depth(flow), 2 * std::pow(2, 0.59), 1e-12);
  flow.settling_velocity = 0.01;
  EXPECT_NEAR(laursen_live_bed_depth(flow), 2 * std::pow(2, 0.69), 1e-12);
  flow.flow_ratio = std::pow(2, 7.0 / 6);
  EXPECT_NEAR(laursen_live_bed_depth(flow), 4 * std::pow(2, 0.69), 1e-12);
  flow.contracted_width = 40;
  flow.flow_ratio = 1;
  EXPECT_EQ(laursen_live_bed_depth(flow), 2);  // nothing narrows it, nothing is scoured
}

// Published example (San Diego State University's calculator of the HEC-18 formula): Q = 10 m^3/s, W2 = 8 m, D50 = 5
// mm and a depth of 0.8 m give 0.263 m of scour.
TEST(LaursenContraction, GivesThePublishedClearWaterExample) {
  const LaursenClearWater flow{.discharge = 10.0 / 8, .grain_diameter = 5e-3, .relative_density = 2.65};
  EXPECT_NEAR(laursen_clear_water_depth(flow) - 0.8, 0.263, 1e-3);
}

// Clear water scours until the flow in the contraction is at Laursen's critical velocity of D_m: q2/y2 = V_c(y2,
// D_m), since
// 0.025 is 1/6.19^2 = 0.0261 within 4.5 %, which makes 2.1 % of the velocity.
TEST(LaursenContraction, EndsAtTheCriticalVelocityInClearWater) {
  const LaursenClearWater flow{.discharge = 1.25, .grain_diameter = 5e-3, .relative_density = 2.65};
  const double y2 = laursen_clear_water_depth(flow);
  EXPECT_NEAR(1.25 / y2, laursen_critical_velocity(y2, 1.25 * 5e-3, 2.65), 0.022 * 1.25 / y2);
}

TEST(LaursenContraction, SaysWhichOfTheTwoHolds) {
  EXPECT_EQ(names_of(limits_left(LaursenLiveBed{
                .depth = 1, .width = 2, .contracted_width = 3, .velocity = 0.4, .critical_velocity = 0.5})),
            "V/Vc< W2/W1> ");
  EXPECT_EQ(names_of(limits_left(LaursenClearWater{.discharge = 1,
                                                   .grain_diameter = 1e-3,
                                                   .relative_density = 1.54,
                                                   .velocity = 0.6,
                                                   .critical_velocity = 0.5})),
            "V/Vc> s< ");
}

const DeySarkarWallJet dey_sarkar_jet{.velocity = 1.21,
                                      .opening = 0.015,
                                      .apron = 0.4,
                                      .tailwater = 0.163,
                                      .grain_diameter = 0.8e-3,
                                      .relative_density = 2.65};

// F0 = 1.21/sqrt(1.65 * 9.81 * 0.0008) = 10.6332. 2.59 * 0.015 * 10.6332^0.94 * 26.667^-0.37 * 10.867^0.16 *
// 0.053333^0.25 = 0.03885 * 9.22698 * 0.296671 * 1.464764 * 0.480561 = 0.07488 m
TEST(DeySarkarScour, HasTheHandWorkedValue) {
  EXPECT_NEAR(densimetric_froude(dey_sarkar_jet), 10.6332, 1e-4);
  EXPECT_NEAR(dey_sarkar_scour(dey_sarkar_jet), 0.07488, 1e-5);
  EXPECT_EQ(names_of(limits_left(dey_sarkar_jet)), "");
}

TEST(DeySarkarScour, ScalesAfterFroude) {
  const DeySarkarWallJet larger{.velocity = 2.42,
                                .opening = 0.06,
                                .apron = 1.6,
                                .tailwater = 0.652,
                                .grain_diameter = 3.2e-3,
                                .relative_density = 2.65};
  EXPECT_NEAR(dey_sarkar_scour(larger) / dey_sarkar_scour(dey_sarkar_jet), 4, 1e-12);
}

// Fr^2 = 1.21^2/(9.81 * 0.015) = 9.9497: 0.0075 (sqrt(80.597) - 1) = 0.05983 m
TEST(DeySarkarScour, SaysThatAJetIsNotSubmerged) {
  EXPECT_NEAR(sequent_depth(0.015, 1.21, 9.81), 0.05983, 1e-5);
  DeySarkarWallJet shallow = dey_sarkar_jet;
  shallow.tailwater = 0.05;
  shallow.apron = 0;
  shallow.grain_diameter = 5e-3;
  EXPECT_EQ(names_of(limits_left(shallow)), "d50 [mm]> h/sequent depth< l/b< ");
}

const BreusersScour breusers_flow{
    .depth = 1, .velocity = 0.5, .critical_velocity = 0.4, .relative_density = 2.65, .turbulence = 0.1};

// alpha = 2: 330 h * 1.65^1.7/0.6^4.3 = 330 * 3600 s * 2.34273/0.111183 = 2.5032e7 s
TEST(BreusersScourTime, HasTheHandWorkedValue) {
  EXPECT_NEAR(breusers_time(breusers_flow), 2.5032e7, 1e3);
  EXPECT_EQ(breusers_scour(breusers_flow, breusers_time(breusers_flow)), 1);
  EXPECT_EQ(breusers_scour(breusers_flow, 0), 0);
  EXPECT_NEAR(breusers_scour(breusers_flow, breusers_time(breusers_flow) / 32), 0.25, 1e-12);  // 32^-0.4
  EXPECT_EQ(names_of(limits_left(breusers_flow, 3e7)), "y/lambda> ");
}

TEST(BreusersScourTime, EndsAtTheEquilibrium) {
  const double t1 = breusers_time(breusers_flow);
  EXPECT_NEAR(breusers_scour(breusers_flow, t1, 2), 1, 1e-12);  // as deep as the flow after t1 all the same
  EXPECT_NEAR(breusers_scour(breusers_flow, 1e6 * t1, 2), 2, 1e-12);
  EXPECT_EQ(breusers_scour(breusers_flow, t1 / 32, 0.5),
            breusers_scour(breusers_flow, t1 / 32));  // less than the depth
}

TEST(BreusersScourTime, StandsStillBelowTheThreshold) {
  BreusersScour calm = breusers_flow;
  calm.velocity = 0.15;
  EXPECT_TRUE(std::isinf(breusers_time(calm)));
  EXPECT_EQ(breusers_scour(calm, 1e9), 0);
  EXPECT_EQ(names_of(limits_left(calm, 1e9)), "alpha U0/Uc< ");
}

// 4.75 * 2^0.2/20^0.32 = 4.75 * 1.148698/2.608121 = 2.09204 m. With d90 in metres the coefficient is 0.521, as some
// print it.
TEST(SchoklitschDepth, HasTheHandWorkedValue) {
  const SchoklitschPlungePool fall{.discharge = 1, .drop = 2, .grain_90 = 0.02};
  EXPECT_NEAR(schoklitsch_depth(fall), 2.09204, 1e-5);
  EXPECT_NEAR(schoklitsch_depth(fall), 0.521 * std::pow(2, 0.2) / std::pow(0.02, 0.32), 1e-3);
}

const MasonArumugamPlungePool mason_fall{.discharge = 0.1, .drop = 1, .tailwater = 0.2, .grain_diameter = 5e-3};

// 3.27 * 0.251189 * 0.785515/(1.983768 * 0.588704) = 0.55246 m; K = 3.32 and 0.1^(0.6 - 1/300) in the general form:
// 0.56523 m
TEST(MasonArumugamDepth, HasTheHandWorkedValues) {
  EXPECT_NEAR(mason_arumugam_model_depth(mason_fall), 0.55246, 1e-5);
  EXPECT_NEAR(mason_arumugam_depth(mason_fall), 0.56523, 1e-5);
  EXPECT_EQ(names_of(limits_left(mason_fall)), "");
  EXPECT_EQ(names_of(limits_left_of_models(mason_fall)), "");
}

// Of the dimension of a length: 2 * 0.60 + 0.05 + 0.15 - 0.30 - 0.10 = 1 metre and -0.60 + 2 * 0.30 = 0 seconds.
// Lengths times 9 and times times 3 therefore give nine times the depth.
TEST(MasonArumugamDepth, HasTheDimensionOfALengthInItsFormForModels) {
  const MasonArumugamPlungePool larger{.discharge = 2.7, .drop = 9, .tailwater = 1.8, .grain_diameter = 45e-3};
  EXPECT_NEAR(mason_arumugam_model_depth(larger) / mason_arumugam_model_depth(mason_fall), 9, 1e-12);
  EXPECT_EQ(names_of(limits_left_of_models(larger)), "H [m]> q [m^2/s]> d [mm]> ");
}

// The general form was made to take over the one for models: within a tenth of it over their range of H.
TEST(MasonArumugamDepth, AgreesWithItsFormForModels) {
  for (const double drop : {0.4, 1.0, 2.0}) {
    MasonArumugamPlungePool fall = mason_fall;
    fall.drop = drop;
    EXPECT_NEAR(mason_arumugam_depth(fall) / mason_arumugam_model_depth(fall), 1, 0.1) << drop;
  }
  EXPECT_EQ(
      names_of(limits_left(MasonArumugamPlungePool{.discharge = 1, .drop = 0.1, .tailwater = 1, .grain_diameter = 1})),
      "H [m]< ");
}

const PipelineScour mao_pipe{.diameter = 0.05,
                             .gap = 0,
                             .shields = 0.33,
                             .critical_shields = 0.047,
                             .grain_diameter = 0.36e-3,
                             .relative_density = 2.65};

// 0.05^2/sqrt(9.81 * 1.65 * 0.00036^3) = 90.97 s; 0.33^(-5/3)/50 = 0.12692
TEST(PipelineScourLaws, HaveTheHandWorkedValues) {
  EXPECT_NEAR(pipeline_scour(mao_pipe), 0.03, 1e-15);
  EXPECT_NEAR(pipeline_time_scale(mao_pipe), 11.546, 1e-3);
  EXPECT_EQ(names_of(limits_left(mao_pipe)), "");
  PipelineScour lifted = mao_pipe;
  lifted.gap = 0.01;
  lifted.shields = 0.03;
  EXPECT_EQ(names_of(limits_left(lifted)), "theta/theta_cr< e/D> ");
}

// 0.01/sqrt(9.81 * 1.65 * 0.0003^3) = 478.34 s; (1/2000) * 2 * 0.1^-2.2 = 0.158489
TEST(PierTimeScaleLaw, HasTheHandWorkedValue) {
  const PierTimeScale pier{.diameter = 0.1,
                           .depth = 0.2,
                           .shields = 0.1,
                           .critical_shields = 0.045,
                           .grain_diameter = 0.3e-3,
                           .relative_density = 2.65};
  EXPECT_NEAR(pier_time_scale(pier), 75.813, 1e-3);
  EXPECT_EQ(names_of(limits_left(pier)), "");
}

TEST(ScourLimits, AreNotLeftByWhatNobodyKnows) {
  EXPECT_TRUE(Limits().between("x", std::nan(""), 0, 1).left().empty());
  EXPECT_TRUE(Limits().between("x", 1, 0, 1).left().empty());
  EXPECT_EQ(names_of(Limits().between("x", 2, 0, 1).between("y", -1, 0, 1).left()), "x> y< ");
}

}  // namespace
}  // namespace thalweg
