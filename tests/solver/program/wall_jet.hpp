#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/solver/case_run.hpp"
#include "tests/solver/program/row_speeds.hpp"

namespace thalweg::test {

/// Runs a plane wall jet of 1.2 m/s, 15 mm thick, and compares its largest velocity, averaged from 1.5 to 2.5 s and over x/b
/// from 15 to 25, with the measured U 3.5/sqrt(x/b) (Rajaratnam 1976, Turbulent Jets). With the mixing length of a channel
/// alone it is 0.78 of that.
inline void expect_a_jet_that_slows_down_as_measured(const std::string& spacing) {
  CaseRun run("wall_jet");
  run.fill_from(THALWEG_SOURCE_DIR "/bench/speed_vs_error/scenes/wall_jet/case.toml",
                {"numerics.spacing=\"" + spacing + "\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const std::vector<ParticleSet> snapshots = snapshots_from(run, 1.45);
  constexpr double b = 0.015;  // [m]
  constexpr std::array places{15, 17, 19, 21, 23, 25};
  double share = 0;
  for (const int place : places) {
    const Reach reach{(place - 0.5) * b, (place + 0.5) * b};
    const std::vector<double> speeds = row_speeds(snapshots, run.scene().numerics.spacing, reach);
    const double largest = *std::max_element(speeds.begin(), speeds.end());
    share += largest / (1.2 * 3.5 / std::sqrt(place)) / places.size();
  }
  testing::Test::RecordProperty("share", std::to_string(share));
  EXPECT_NEAR(share, 1, 0.1) << spacing;
}

}  // namespace thalweg::test
