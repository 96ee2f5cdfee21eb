#include "foam_reference/solver_log.hpp"

#include <gtest/gtest.h>

#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

constexpr const char* first_lines =
    "Build  : OPENFOAM=1912 patch=200626\n"
    "Courant Number mean: 0 max: 0\n"
    "deltaT = 0.002\n"
    "Time = 0.002\n"
    "\n"
    "time step continuity errors : sum local = 1e-09, global = 2e-10, cumulative = 3e-10\n"
    "time step continuity errors : sum local = 1e-09, global = 2e-10, cumulative = 5e-10\n"
    "deltaT = 0.0";

TEST(SolverLog, FollowsALogThatGrowsInTheMiddleOfALine) {
  const TemporaryFolder folder;
  SolverLog log(folder.path() / "log");
  log.read_on();
  EXPECT_TRUE(log.steps().empty());

  folder.write("log", first_lines);
  log.read_on();
  ASSERT_EQ(log.steps().size(), 1U);
  EXPECT_DOUBLE_EQ(log.steps()[0].time, 0.002);
  EXPECT_DOUBLE_EQ(log.steps()[0].dt, 0.002);
  EXPECT_DOUBLE_EQ(log.steps()[0].continuity_error, 5e-10);
  EXPECT_EQ(log.version(), "OPENFOAM=1912 patch=200626");

  folder.write("log", std::string(first_lines) + "03\nTime = 0.005\n");
  log.read_on();
  ASSERT_EQ(log.steps().size(), 2U);
  EXPECT_DOUBLE_EQ(log.steps()[1].dt, 0.003);
}

TEST(FatalMessage, IsTheTextAfterTheAnnouncement) {
  const TemporaryFolder folder;
  const auto file = folder.write("log",
                                 "Create time\n\n--> FOAM FATAL IO ERROR: \nkeyword div(phi,U) is undefined\n"
                                 "in dictionary \"system/fvSchemes\"\n\n    From function lookup\n");
  EXPECT_EQ(fatal_message(file), "keyword div(phi,U) is undefined in dictionary \"system/fvSchemes\"");
}

TEST(FatalMessage, KnowsAFloatingPointException) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("log", "Time = 1\n#0  Foam::error::printStack(Foam::Ostream&)\n#1  Foam::sigFpe::sigHandler(int)\n");
  EXPECT_EQ(fatal_message(file), "floating point exception");
}

}  // namespace
}  // namespace thalweg::foam
