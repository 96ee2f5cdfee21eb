#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/case_run.hpp"
#include "tests/solver/program/row_speeds.hpp"

// Water that enters with speeds measured over height and width.
namespace thalweg {
namespace {

// Exact: the table is bilinear, so that its mean is 0.375 m/s, which the flow rate of 0.4 m/s times the section scales.
TEST(OpenChannel, EntersWithTheSpeedsOfASection) {
  test::CaseRun run("section");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/openings/section.toml", {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double spacing = run.scene().numerics.spacing;
  double squares = 0;
  double number = 0;
  double sides[2] = {0, 0};
  for (const ParticleSet& p : test::snapshots_from(run, 0.5)) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3& x = p.position[i];
      if (p.type[i] != ParticleType::water || x.x() < 0 || x.x() > 3 * spacing) continue;
      const double exact = (0.25 + 0.05 * x.y() / 0.06) * (1 + x.z() / 0.08) * 0.4 / 0.375;
      squares += std::pow(double(p.velocity[i].x()) - exact, 2);
      number += 1;
      sides[x.y() > 0 ? 1 : 0] += double(p.velocity[i].x());
    }
  }
  ASSERT_GT(number, 1000);
  EXPECT_LT(std::sqrt(squares / number), 0.04 * 0.4);     // 0.018 measured
  EXPECT_NEAR(sides[1] / sides[0], 0.275 / 0.225, 0.03);  // left against right

  const CsvTable history = CsvTable::read(run.folder().history());
  const auto time = history.numbers("time", "s");
  const auto entered = history.numbers("west_water", "kg");
  const double rate = (entered.back() - entered.front()) / (time.back() - time.front());
  EXPECT_NEAR(rate, 3.84, 0.02 * 3.84);
}

}  // namespace
}  // namespace thalweg
