#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/solver/case_run.hpp"

namespace thalweg {
namespace {

using testing::HasSubstr;

std::string message_of(const RunOptions& options) {
  try {
    run_solver(options);
  } catch (const RunError& e) {
    return e.what();
  }
  return "it did not fail";
}

TEST(Divergence, IsDiagnosedAndLosesNothing) {
  // A column that falls nearly as fast as its sound: must stop with particle, time and cure, keep what was written, and
  // hold no NaN files.
  test::CaseRun run("diverging");
  run.fill("dam_break", {"numerics.maximum_speed=\"0.2 m/s\""});
  const std::string message = message_of(run.options());
  EXPECT_THAT(message, HasSubstr("run failed at t = "));
  EXPECT_THAT(message, HasSubstr("particle "));
  EXPECT_THAT(message, HasSubstr("the sound speed is meant for 0.2 m/s; raise numerics.maximum_speed"));
  EXPECT_TRUE(std::filesystem::exists(run.folder().root / "diverged.vtp"));
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    for (const auto& u : read_particles(run.folder().root / e.file).velocity) EXPECT_TRUE(u.allFinite());
  }
}

TEST(Exclusion, IsCountedListedAndBounded) {
  // No far wall: the front runs out of the domain. Allowed: counted and listed. Not allowed: an error that says where.
  test::CaseRun run("leaving");
  const std::vector<std::string> shorter = {"domain.to=[\"0.25 m\", \"0.4 m\"]",
                                            "shape.tank.to=[\"0.24 m\", \"0.3 m\"]", "shape.tank.open=[\"+z\", \"+x\"]",
                                            "output.end=\"0.15 s\"", "compare.times=[]"};
  std::vector<std::string> tolerant = shorter;
  tolerant.emplace_back("numerics.excluded_limit=1");
  run.fill("dam_break", tolerant);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const auto excluded = CsvTable::read(run.folder().history()).numbers("excluded", "-");
  EXPECT_GT(excluded.back(), 0);
  EXPECT_EQ(static_cast<double>(CsvTable::read(run.folder().excluded()).rows()), excluded.back());

  test::CaseRun strict("leaving_strict");
  strict.fill("dam_break", shorter);
  EXPECT_THAT(message_of(strict.options()), HasSubstr("fluid particles have left the domain"));
}

}  // namespace
}  // namespace thalweg
