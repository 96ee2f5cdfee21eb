#include <gtest/gtest.h>

#include "tests/solver/program/flat_bed.hpp"

// Bed load against the law that it has to follow, in water with noise, at two spacings; the momentum that the water loses
// against the stress that moves the grains. The bounds of issue and law: q within 0.95 and 1.1 where grains move, none where
// they do not; momentum within 5 %.
namespace thalweg {
namespace {

using test::FlatBed;
using test::FlatBedResult;
using test::FlatBedRun;

class BedLoadFlow : public testing::TestWithParam<FlatBed> {};

TEST_P(BedLoadFlow, FollowsTheLawAndBrakesTheWaterByIt) {
  const FlatBedResult r = FlatBedRun(GetParam()).result();
  EXPECT_GT(r.flux_of_law, 0);
  EXPECT_NEAR(r.flux / r.flux_of_law, 1.02, 0.08);
  EXPECT_NEAR(r.stress_found / r.stress_shown, 1, 0.05);
  EXPECT_LT(r.highest, 0.5);  // the surface stays whole
}

std::string name_of(const testing::TestParamInfo<FlatBed>& test) {
  const FlatBed& b = test.param;
  return "dp_" + std::to_string(std::lround(1e4 * b.spacing)) + "_d_" + std::to_string(std::lround(1e4 * b.diameter)) +
         "_stage_" + std::to_string(std::lround(10 * b.stage)) + "_seed_" + std::to_string(b.seed);
}

INSTANTIATE_TEST_SUITE_P(Sand, BedLoadFlow,
                         testing::Values(FlatBed{.spacing = 0.01, .diameter = 1e-3, .stage = 1.5},
                                         FlatBed{.spacing = 0.01, .diameter = 2e-3, .stage = 8, .seed = 2},
                                         FlatBed{.spacing = 0.005, .diameter = 0.5e-3, .stage = 3},
                                         FlatBed{.spacing = 0.005, .diameter = 2e-3, .stage = 8, .seed = 3}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Pvc, BedLoadFlow,
                         testing::Values(FlatBed{
                             .spacing = 0.005, .diameter = 3.5e-3, .grain_density = 1540, .stage = 8}),
                         name_of);

class BedAtRest : public testing::TestWithParam<FlatBed> {};

TEST_P(BedAtRest, MovesNoGrain) {
  const FlatBedResult r = FlatBedRun(GetParam()).result();
  EXPECT_EQ(r.flux, 0);
  EXPECT_EQ(r.resting_share, 1);
  EXPECT_LT(r.highest, -0.45);
}

INSTANTIATE_TEST_SUITE_P(BelowThreshold, BedAtRest,
                         testing::Values(FlatBed{.spacing = 0.01, .diameter = 1e-3, .stage = 0.7},
                                         FlatBed{.spacing = 0.005, .diameter = 2e-3, .stage = 0.7}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Cohesive, BedAtRest,
                         testing::Values(FlatBed{.spacing = 0.005,
                                                 .diameter = 1e-3,
                                                 .stage = 8,
                                                 .end = 0.6,
                                                 .options = {"materials.sand.cohesion=\"100 kPa\""}}),
                         name_of);

// A grain that sinks sees the floor as it sees a bed: it stops on it, and does not go into it by a spacing.
TEST(GrainInSuspension, LandsOnABareFloor) {
  test::CaseRun run("grain_on_floor");
  run.fill("stability/grain", {"shape.drop.from=[\"0 m\", \"0 m\"]", "shape.drop.to=[\"0.1 m\", \"0.1 m\"]",
                               "output.end=1.5 s", "output.interval=0.1 s"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double spacing = run.scene().numerics.spacing;
  for (const double time : {1.0, 1.5}) {
    const ParticleSet p = run.snapshot_at(time);
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.type[i] != ParticleType::sediment) continue;
      EXPECT_GT(p.position[i].z(), 0.3 * spacing) << time;
      EXPECT_LT(p.position[i].z(), 1.5 * spacing) << time;
    }
  }
}

TEST(BedWithoutFriction, FlowsWithoutALossOfNumbers) {
  const FlatBedResult r = FlatBedRun({.spacing = 0.01,
                                      .diameter = 1e-3,
                                      .stage = 3,
                                      .end = 0.6,
                                      .options = {"materials.sand.friction_angle=\"0 deg\""}})
                              .result();
  EXPECT_TRUE(std::isfinite(r.flux));
}

}  // namespace
}  // namespace thalweg
