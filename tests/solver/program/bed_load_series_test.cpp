#include <gtest/gtest.h>

#include "tests/solver/program/flat_bed.hpp"

// The series behind bed_load_test: three sands and PVC at three spacings, below and above the threshold, with three seeds
// of the noise, and one run in space. Minutes.
namespace thalweg {
namespace {

using test::FlatBed;
using test::FlatBedResult;
using test::FlatBedRun;

struct Sand {
  double diameter;
  double density;
};

class BedLoadSeries : public testing::TestWithParam<std::tuple<double, Sand, unsigned>> {};

TEST_P(BedLoadSeries, FollowsTheLawAtEveryStage) {
  const auto& [spacing, sand, seed] = GetParam();
  for (const double stage : {0.7, 1.5, 3.0, 8.0}) {
    const FlatBedResult r = FlatBedRun({.spacing = spacing,
                                        .diameter = sand.diameter,
                                        .grain_density = sand.density,
                                        .stage = stage,
                                        .seed = seed})
                                .result();
    std::printf("dp %4.1f mm, d %3.1f mm, theta/theta_cr %3.1f, seed %u: q/law %.3f, momentum lost over stress %.3f\n",
                1e3 * spacing, 1e3 * sand.diameter, stage, seed, r.flux_of_law > 0 ? r.flux / r.flux_of_law : 0.0,
                r.stress_found / r.stress_shown);
    if (r.flux_of_law == 0) {
      EXPECT_EQ(r.flux, 0) << stage;
      EXPECT_EQ(r.resting_share, 1) << stage;
    } else if (stage > 1) {
      EXPECT_NEAR(r.flux / r.flux_of_law, 1.02, 0.08) << stage;
      EXPECT_NEAR(r.stress_found / r.stress_shown, 1, 0.05) << stage;
    }
  }
}

std::string name_of(const testing::TestParamInfo<BedLoadSeries::ParamType>& test) {
  const auto& [spacing, sand, seed] = test.param;
  return "dp_" + std::to_string(std::lround(1e4 * spacing)) + "_d_" + std::to_string(std::lround(1e4 * sand.diameter)) +
         "_seed_" + std::to_string(seed);
}

INSTANTIATE_TEST_SUITE_P(All, BedLoadSeries,
                         testing::Combine(testing::Values(0.01, 0.005, 0.0025),
                                          testing::Values(Sand{0.5e-3, 2650}, Sand{1e-3, 2650}, Sand{2e-3, 2650},
                                                          Sand{3.5e-3, 1540}),
                                          testing::Values(1U, 2U, 3U)),
                         name_of);

TEST(BedLoadInSpace, FollowsTheLaw) {
  const FlatBedResult r =
      FlatBedRun({.spacing = 0.005, .diameter = 2e-3, .stage = 3, .end = 0.6, .dimension = 3}).result();
  EXPECT_NEAR(r.flux / r.flux_of_law, 1.02, 0.08);
  EXPECT_NEAR(r.stress_found / r.stress_shown, 1, 0.05);
}

}  // namespace
}  // namespace thalweg
