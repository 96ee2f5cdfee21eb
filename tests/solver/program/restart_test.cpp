#include <gtest/gtest.h>

#include <csignal>

#include "common/error.hpp"
#include "tests/solver/program/broken_run.hpp"

namespace thalweg {
namespace {

const std::vector<std::string> short_louvain = {"numerics.spacing=\"20 mm\"", "output.end=\"0.1 s\"",
                                                "output.interval=\"0.05 s\"", "compare.times=[]"};

/// Options that keep more of a particle than others, and where the run is broken off.
struct Continued {
  const char* name;
  std::vector<std::string> options;
  const char* until = "0.05 s";
};
void PrintTo(const Continued& c, std::ostream* to) { *to << c.name; }

class Restart : public testing::TestWithParam<Continued> {};

TEST_P(Restart, ContinuesBitForBit) {
  std::vector<std::string> overrides = short_louvain;
  overrides.insert(overrides.end(), GetParam().options.begin(), GetParam().options.end());
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(test::case_folder("louvain"), overrides, GetParam().until, ends));
  // The continued run's series and history read as one run's.
  const RunFolder& broken = ends.broken_run.folder();
  EXPECT_EQ(read_series(broken.snapshot_series()).size(), 3U);
  const auto time = CsvTable::read(broken.history()).numbers("time", "s");
  for (std::size_t i = 1; i < time.size(); ++i) EXPECT_GT(time[i], time[i - 1]);
}
INSTANTIATE_TEST_SUITE_P(
    Options, Restart,
    testing::Values(Continued{"three_states", {}},
                    Continued{"at_rest", {"output.end=\"0.4 s\"", "output.interval=\"0.2 s\""}, "0.2 s"},
                    Continued{"laplace", {"model.effective_pressure=laplace"}},
                    Continued{"mixture", {"model.sediment=viscoplastic", "model.seepage=mixture"}},
                    Continued{"pore_pressure", {"model.pore_pressure=diffusion"}},
                    Continued{"shifting", {"numerics.shifting=on"}},
                    Continued{"mixing_length", {"model.turbulence=mixing-length", "model.wall_friction=smooth"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(RestartCheck, RefusesACheckpointThatIsAtTheEnd) {
  test::CaseRun run("at_end");
  run.fill("louvain", short_louvain);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  RunOptions again = run.options();
  again.restart = run.folder().checkpoint();
  EXPECT_THROW(run_solver(again), InputError);
}

TEST(RunFolderCheck, NamesWhatIsMissing) {
  test::CaseRun run("empty");
  try {
    run_solver(run.options());
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("fill the scene first: thalweg gencase CASE"), std::string::npos);
  }
}

}  // namespace
}  // namespace thalweg
