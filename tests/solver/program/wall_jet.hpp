#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/solver/case_run.hpp"

namespace thalweg::test {

/// Runs a plane wall jet of 1.2 m/s, 15 mm thick. Its largest velocity falls as U 3.5/sqrt(x/b) (Rajaratnam 1976, Turbulent
/// Jets, with measurements from 3.2 to 3.8), from x/b = 15 to 25, averaged over its second second. The mixing length of a
/// channel without that of free shear layers makes 0.78 of it.
inline void expect_a_jet_that_slows_down_as_measured(const std::string& spacing) {
  CaseRun run("wall_jet");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/openings/wall_jet.toml",
                {"numerics.spacing=\"" + spacing + "\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  constexpr double b = 0.015;  // [m]
  constexpr std::array places{15, 17, 19, 21, 23, 25};
  double share = 0;
  for (const int place : places) {
    // Mean over time of the velocity of each row of the jet; the fastest row is the jet's.
    const double dp = run.scene().numerics.spacing;
    std::array<double, 20> sum{};
    std::array<double, 20> number{};
    for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
      if (e.time < 1.45) continue;
      const ParticleSet p = read_particles(run.folder().root / e.file);
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3& x = p.position[i];
        if (p.type[i] != ParticleType::water || std::abs(x.x() - place * b) > b / 2 || x.z() < 0) continue;
        const auto row = static_cast<std::size_t>(x.z() / dp);
        if (row < sum.size()) sum[row] += double(p.velocity[i].x()), number[row] += 1;
      }
    }
    double fastest = 0;
    for (std::size_t row = 0; row < sum.size(); ++row)
      fastest = std::max(fastest, sum[row] / std::max(1.0, number[row]));
    share += fastest / (1.2 * 3.5 / std::sqrt(place)) / places.size();
  }
  testing::Test::RecordProperty("share", std::to_string(share));
  EXPECT_NEAR(share, 1, 0.1) << spacing;
}

}  // namespace thalweg::test
