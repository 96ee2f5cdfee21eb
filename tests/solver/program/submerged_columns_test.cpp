#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solver/case_run.hpp"

// Two columns that differ in their packing alone: the dense one sucks itself fast, the loose one runs out on the water that
// it presses out (cases/submerged_columns).
namespace thalweg {
namespace {

struct Column {
  double toe = 0;            // [m] the farthest place where it is 4 mm high
  double pore_pressure = 0;  // [Pa] mean over the bed below 6 mm and within 5 cm of the wall, at its extreme
};

Column collapse(const std::string& name, const std::vector<std::string>& more) {
  test::CaseRun run(name);
  std::vector<std::string> overrides = {"numerics.spacing=\"3 mm\"", "output.end=\"2 s\"", "output.interval=\"0.5 s\""};
  overrides.insert(overrides.end(), more.begin(), more.end());
  run.fill("submerged_columns", overrides);
  EXPECT_EQ(run_solver(run.options()), Exit::done);
  const double dp = run.scene().numerics.spacing;
  Column found;
  for (const double t : {0.5, 1.0, 1.5, 2.0}) {
    const ParticleSet at = run.snapshot_at(t);
    const std::vector<float>& excess = at.scalars.at("ExcessPorePressure");
    std::vector<double> height(200, 0.0);
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at.type[i] != ParticleType::sediment) continue;
      const Vec3& x = at.position[i];
      const auto column = static_cast<std::size_t>(std::max(0.0, x.x() / (2 * dp)));
      if (column < height.size()) height[column] += dp / 2;
      if (x.z() < 0.006 && x.x() < 0.05) sum += double(excess[i]), ++count;
    }
    if (std::abs(sum / count) > std::abs(found.pore_pressure)) found.pore_pressure = sum / count;
    found.toe = 0;
    for (std::size_t c = 0; c < height.size(); ++c) {
      if (height[c] > 0.004) found.toe = static_cast<double>(c + 1) * 2 * dp;
    }
  }
  return found;
}

TEST(SubmergedColumns, ADenseOneStandsInSuctionAndALooseOneRunsOut) {
  const Column dense = collapse("dense_column", {});
  const Column loose =
      collapse("loose_column", {"materials.beads.porosity=0.448", "shape.column.to=[\"0.06 m\", \"0.048 m\"]"});
  EXPECT_LT(dense.toe, test::limit_of("submerged_columns", "dense_toe"));
  EXPECT_GT(loose.toe, test::limit_of("submerged_columns", "loose_toe"));
  EXPECT_LT(dense.pore_pressure, -20);  // of some 370 Pa that the column weighs in water
  EXPECT_GT(loose.pore_pressure, 20);
}

}  // namespace
}  // namespace thalweg
