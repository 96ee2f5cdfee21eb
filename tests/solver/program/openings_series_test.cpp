#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/case_run.hpp"
#include "tests/solver/program/trend.hpp"
#include "tests/solver/program/wall_jet.hpp"

// Runs that are too long for every test: a minute of uniform flow between an inlet and a tail water, whose level, discharge,
// mass and pressure stay as they are, and a jet at a finer spacing.
namespace thalweg {
namespace {

constexpr double depth = 0.1;  // [m]

void expect_a_steady_minute(const std::string& scene, const std::vector<std::string>& options, double width) {
  test::CaseRun run("open_minute");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/openings/" + scene, options);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double spacing = run.scene().numerics.spacing;
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto t = history.numbers("time", "s");
  std::size_t first = 0;
  while (t[first] < 10) ++first;
  // 0.04 m^2/s of water that is compressed by 1.2e-3 in the mean, 490 Pa over rho c^2.
  const double entering = 40 * width * (1 + 490 / (1000 * 19.81 * 19.81));
  EXPECT_NEAR(test::trend(t, history.numbers("west_water", "kg"), first), entering, 0.005 * entering);
  EXPECT_NEAR(-test::trend(t, history.numbers("east_water", "kg"), first), entering, 0.005 * entering);
  for (const char* name : {"west_level", "east_level"}) {
    const auto level = history.numbers(name, "m");
    double mean = 0;
    for (std::size_t i = first; i < t.size(); ++i) mean += level[i] / static_cast<double>(t.size() - first);
    EXPECT_NEAR(mean, depth, 0.5 * spacing) << name;
  }
  const auto water = history.numbers("water_mass", "kg");
  const auto in = history.numbers("mass_in", "kg");
  const auto out = history.numbers("mass_out", "kg");
  for (std::size_t i = 0; i < t.size(); ++i) {
    EXPECT_NEAR(water[i] - in[i] + out[i], water[0] - in[0] + out[0], 1e-6 * water[0]) << t[i];
  }
  // No drift: the straight line through 50 s changes by less than a column of particles.
  EXPECT_LT(std::abs(test::trend(t, water, first)) * 50, depth * spacing * width * 1000);

  // Mean pressure of each row of particles, in the middle of the channel.
  const auto rows = static_cast<std::size_t>(std::lround(depth / spacing));
  std::vector<double> deficit(rows, 0.0);
  std::vector<double> number(rows, 0.0);
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < 10) continue;
    const ParticleSet p = read_particles(run.folder().root / e.file);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3& x = p.position[i];
      if (p.type[i] != ParticleType::water || x.x() < 0.1 || x.x() > run.scene().outlets[0].at.x() - 0.05) continue;
      const auto row = std::min(rows - 1, static_cast<std::size_t>(std::max(0.0, x.z() / spacing)));
      deficit[row] += 9810 * (depth - x.z()) - double(p.pressure[i]);
      number[row] += 1;
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    EXPECT_LT(deficit[row] / number[row], 0.025 * 9810 * depth) << "row " << row;  // 2 % in the row next to the top
  }
}

TEST(OpenMinute, InThePlaneAtTenMillimetres) { expect_a_steady_minute("channel.toml", {"output.end=\"60 s\""}, 1); }

TEST(OpenMinute, InThePlaneAtFiveMillimetres) {
  expect_a_steady_minute("channel.toml",
                         {"output.end=\"60 s\"", "numerics.spacing=\"5 mm\"", "shape.water.to=[\"1.03 m\", \"0.1 m\"]"},
                         1);
}

TEST(OpenMinute, InSpace) { expect_a_steady_minute("space.toml", {}, 0.1); }

TEST(WallJet, SlowsDownAsMeasuredWithFourRowsToo) { test::expect_a_jet_that_slows_down_as_measured("3.75 mm"); }

}  // namespace
}  // namespace thalweg
