#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/case_run.hpp"

// Kynch's exact answer (cases/batch_sedimentation/README.md): the edge of the clear water falls at w, a bed of the
// concentration 0.6 rises at w C/(0.6 - C).
namespace thalweg {
namespace {

constexpr double C = 0.1;                          // at the start
constexpr double depth = 0.2;                      // [m]
const double w = 0.02618 * std::pow(1 - C, 4.65);  // [m/s] Soulsby's 0.02618 for one grain of 0.2 mm
const double rise = w * C / (0.6 - C);             // [m/s]

TEST(BatchSedimentation, FollowsKynchForFourSeconds) {
  test::CaseRun run("batch_sedimentation");
  run.fill("batch_sedimentation", {"output.end=\"4 s\"", "output.interval=\"1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto time = history.numbers("time", "s");
  const auto all = history.numbers("grain_mass", "kg");
  const auto suspended = history.numbers("suspended_mass", "kg");
  for (std::size_t row = 0; row < time.size(); ++row) {
    EXPECT_NEAR(all[row] / all[0], 1, test::limit_of("batch_sedimentation", "grain_mass")) << time[row];
  }
  const double t = time.back();
  const double due = (depth - (w + rise) * t) / depth;
  EXPECT_NEAR(suspended.back() / suspended[0] / due, 1, test::limit_of("batch_sedimentation", "suspended_mass"));

  // The edge: half of the concentration, from the mean of the upper half's shortfall.
  const ParticleSet end = run.snapshot_at(t);
  const std::vector<float>& concentration = end.scalars.at(concentration_array);
  const double dp = run.scene().numerics.spacing;
  double carried = 0;  // [m] height of suspension above half of the depth
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] != ParticleType::water || end.position[i].z() < depth / 2) continue;
    carried += double(concentration[i]) / C * dp * dp / 0.1;
  }
  EXPECT_NEAR(depth / 2 + carried, depth - w * t, test::limit_of("batch_sedimentation", "interface") * dp);
}

}  // namespace
}  // namespace thalweg
