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

TEST(BatchSedimentation, FollowsKynch) {
  test::CaseRun run("batch_sedimentation");
  run.fill("batch_sedimentation", {"output.end=\"3 s\"", "output.interval=\"1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto all = history.numbers("grain_mass", "kg");
  for (const double mass : all) {
    EXPECT_NEAR(mass / all[0], 1, test::limit_of("batch_sedimentation", "grain_mass"));
  }

  // The edge of the clear water, and the grains below a fifth of the way up, by their heights of pure suspension.
  const double t = 3;
  const ParticleSet end = run.snapshot_at(t);
  const std::vector<float>& concentration = end.scalars.at(concentration_array);
  const double dp = run.scene().numerics.spacing;
  const double low = 0.03;  // [m]
  double above = 0;
  double below = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const bool water = end.type[i] == ParticleType::water;
    if (!water && end.type[i] != ParticleType::sediment) continue;
    const double height = double(concentration[i]) * (water ? 1 : 0.6) / C * dp * dp / 0.1;
    if (end.position[i].z() > depth / 2) above += height;
    if (end.position[i].z() < low) below += height;
  }
  EXPECT_NEAR(depth / 2 + above, depth - w * t, test::limit_of("batch_sedimentation", "edge") * dp);
  const double due = rise * t * 0.6 / C + (low - rise * t);
  EXPECT_NEAR(below / due, 1, test::limit_of("batch_sedimentation", "grains_below"));
}

}  // namespace
}  // namespace thalweg
