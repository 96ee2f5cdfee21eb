#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/solver/case_run.hpp"

namespace thalweg {
namespace {

/// Edge of the water's tongue over the column's width: half a spacing beyond the third foremost particle, so that two
/// drops thrown ahead do not count.
double front(const ParticleSet& p, double width) {
  std::vector<double> x;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) x.push_back(p.position[i].x());
  }
  std::nth_element(x.begin(), x.end() - 3, x.end());
  return (*(x.end() - 3) + 0.5 * p.info.spacing) / width;
}

class DamBreak : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    run = new test::CaseRun("dam_break");
    run->fill("dam_break", {});
    ASSERT_EQ(run_solver(run->options()), Exit::done);
  }
  static void TearDownTestSuite() { delete run; }
  static test::CaseRun* run;
};
test::CaseRun* DamBreak::run = nullptr;

TEST_F(DamBreak, FrontLiesInTheBandOfTheMeasurements) {
  ASSERT_NEAR(run->scene().numerics.spacing, 0.2 / 40, 1e-12);
  const double width = 0.1;
  const double tolerance = test::limit_of("dam_break", "front");
  const CsvTable band =
      CsvTable::read(std::filesystem::path(THALWEG_SOURCE_DIR) / "cases/dam_break/reference/front.csv");
  const auto t_star = band.numbers("t_star", "-");
  const auto lowest = band.numbers("lowest", "-");
  const auto highest = band.numbers("highest", "-");
  ASSERT_EQ(t_star.size(), run->scene().compare.times.size());
  ASSERT_EQ(t_star.back(), 3);
  for (std::size_t i = 0; i < t_star.size(); ++i) {
    const double x = front(run->snapshot_at(run->scene().compare.times[i]), width);
    EXPECT_GT(x, (1 - tolerance) * lowest[i]) << "t* = " << t_star[i];
    EXPECT_LT(x, (1 + tolerance) * highest[i]) << "t* = " << t_star[i];
    std::cout << "t* = " << t_star[i] << ": front " << x << ", measured " << lowest[i] << " to " << highest[i] << "\n";
  }
}

TEST_F(DamBreak, LosesEnergyOnlyToDissipation) {
  // Gravity and pressure are conservative, artificial viscosity, wall friction and density diffusion dissipate: the
  // total may not rise.
  const CsvTable history = CsvTable::read(run->folder().history());
  const auto kinetic = history.numbers("kinetic_energy", "J");
  const auto potential = history.numbers("potential_energy", "J");
  const auto internal = history.numbers("internal_energy", "J");
  double lowest = kinetic[0] + potential[0] + internal[0];
  const double available = potential[0];
  for (std::size_t i = 1; i < kinetic.size(); ++i) {
    const double total = kinetic[i] + potential[i] + internal[i];
    EXPECT_LT(total, lowest + test::limit_of("dam_break", "energy_gain") * available) << "row " << i;
    lowest = std::min(lowest, total);
  }
  EXPECT_GT(kinetic.back(), 0.5 * (potential.front() - potential.back()));  // most of the fall has become motion
}

TEST_F(DamBreak, KeepsItsMassExactly) {
  const auto mass = CsvTable::read(run->folder().history()).numbers("water_mass", "kg");
  for (const double m : mass) EXPECT_EQ(m, mass[0]);
}

}  // namespace
}  // namespace thalweg
