#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/solver/case_run.hpp"

namespace thalweg {
namespace {

constexpr double gravity = 9.81;

/// Depth of the water in a window around x [m], from its volume.
double depth_at(const ParticleSet& p, double x, double width, double density) {
  double volume = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != ParticleType::water) continue;
    if (std::abs(p.position[i].x() - x) < 0.5 * width) volume += double(p.mass[i]) / density;
  }
  return volume / width;
}

TEST(Wavemaker, MakesWavesAsHighAsLinearTheorySays) {
  test::CaseRun run("wave_flume");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/moving_walls/wave_flume.toml", {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double depth = 0.2, period = 0.8, stroke = 0.02;
  const double omega = 2 * std::numbers::pi / period;
  double k = omega * omega / gravity;
  for (int n = 0; n < 100; ++n) k = omega * omega / (gravity * std::tanh(k * depth));  // converges for kh > 1
  // A piston's wave height over its stroke (Dean & Dalrymple 1991, eq. 6.25).
  const double ratio = 2 * (std::cosh(2 * k * depth) - 1) / (std::sinh(2 * k * depth) + 2 * k * depth);

  // 1.3 wavelengths from the piston its evanescent waves are gone. The first crests, which stand higher since the
  // piston starts at once, travel with 0.77 m/s and have passed at 4.6 s; nothing is back from the far end before 7.7
  // s. The window of 64 mm sees sin(k w/2)/(k w/2) of the height.
  const double x = 1.2, window = 0.064;
  const double seen = std::sin(0.5 * k * window) / (0.5 * k * window);
  std::vector<double> low(3, 1), high(3, 0);
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < 4.6 - 1e-6) continue;
    const double d = depth_at(read_particles(run.folder().root / e.file), x, window, 1000);
    const auto wave = std::min<std::size_t>(2, static_cast<std::size_t>((e.time - 4.6 + 1e-6) / period));
    low[wave] = std::min(low[wave], d), high[wave] = std::max(high[wave], d);
  }
  double height = 0;
  for (std::size_t wave = 0; wave < 3; ++wave) {
    const double own = (high[wave] - low[wave]) / seen;
    std::cout << "wave " << wave << ": height/stroke " << own / stroke << "\n";
    height += own / 3;
  }
  std::cout << "kh " << k * depth << ", height/stroke " << height / stroke << ", linear theory " << ratio << "\n";
  // Three particles to the wave height; sampled 16 times a period (2 %); the waves' own steepness adds 1 %.
  EXPECT_NEAR(height / stroke, ratio, 0.1 * ratio);
}

}  // namespace
}  // namespace thalweg
