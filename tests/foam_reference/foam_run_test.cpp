// Failures of a run, with programs in the place of OpenFOAM's that write the same texts.
#include "foam_reference/foam_run.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <thread>

#include "common/error.hpp"
#include "foam_reference/case_files.hpp"
#include "tests/foam_reference/expect_error.hpp"
#include "tests/foam_reference/small_scene.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

class FoamRunTest : public testing::Test {
 protected:
  FoamRunTest() : path_(std::getenv("PATH")) {
    for (const char* program : {"blockMesh", "setFields", "postProcess"}) stand_in(program, "exit 0");
    setenv("PATH", (folder_.path() / "bin").string().append(":").append(path_).c_str(), 1);
    for (const auto& [name, text] : case_files(make_foam_case(still_tank(), 1))) folder_.write("case" / name, text);
  }
  ~FoamRunTest() override { setenv("PATH", path_.c_str(), 1); }

  void stand_in(const std::string& program, const std::string& script) {
    fs::permissions(folder_.write(fs::path("bin") / program, "#!/bin/sh\n" + script + "\n"), fs::perms::owner_all);
  }
  [[nodiscard]] fs::path case_folder() const { return folder_.path() / "case"; }
  [[nodiscard]] std::string failure() const {
    return message_of<RunError>([&] { run_foam(case_folder(), 0.1); });
  }

  TemporaryFolder folder_;
  std::string path_;
};

TEST_F(FoamRunTest, ReturnsTheStepsOfARunThatEnds) {
  stand_in("multiphaseInterFoam", "printf 'deltaT = 0.05\\nTime = 0.05\\ndeltaT = 0.05\\nTime = 0.1\\n'");
  const FoamRun run = run_foam(case_folder(), 0.1);
  ASSERT_EQ(run.steps.size(), 2U);
  EXPECT_DOUBLE_EQ(run.steps.back().time, 0.1);
  EXPECT_GT(run.wall_seconds, 0);
}

// OpenFOAM cuts paths at blanks and refuses those of more than 1024 characters.
TEST_F(FoamRunTest, GoesAPlainWayToAnyFolder) {
  stand_in("blockMesh", "case \"$PWD\" in *' '*) exit 1 ;; esac; test ${#PWD} -lt 1024");
  stand_in("multiphaseInterFoam", "printf 'deltaT = 0.1\\nTime = 0.1\\n'");
  const std::string name(250, 'd');
  for (const fs::path& way : {fs::path("a b"), fs::path("d") / name / name / name / name}) {
    for (const auto& [file, text] : case_files(make_foam_case(still_tank(), 1))) folder_.write(way / file, text);
    EXPECT_EQ(run_foam(folder_.path() / way, 0.1).steps.size(), 1U);
  }
}

TEST_F(FoamRunTest, SaysAtWhichTimeAndInWhichLogTheSolverFailed) {
  stand_in(
      "multiphaseInterFoam",
      "printf 'deltaT = 0.01\\nTime = 0.04\\n--> FOAM FATAL ERROR: \\nMaximum number of iterations\\n\\n'; exit 1");
  EXPECT_EQ(failure(), (case_folder() / "log.multiphaseInterFoam").string() +
                           ": multiphaseInterFoam failed at t = 0.04 of 0.1 s (Maximum number of iterations); try "
                           "another cell size (--cell), or a smaller maxCo in system/controlDict and ./Allclean && "
                           "./Allrun");
}

TEST_F(FoamRunTest, NamesTheProgramThatFailedBeforeTheSolver) {
  stand_in("setFields", "printf '%s\\n\\n%s\\n\\n' '--> FOAM FATAL ERROR:' 'no such shape'; exit 1");
  EXPECT_EQ(failure(), (case_folder() / "log.setFields").string() +
                           ": setFields failed (no such shape); read this log, check that OpenFOAM and the case fit "
                           "together");
}

TEST_F(FoamRunTest, StopsARunWhoseStepCollapses) {
  stand_in("multiphaseInterFoam",
           "for i in 1 2 3 4 5 6 7 8 9; do printf 'deltaT = 0.002\\nTime = 0.0%s\\n' $i; done\n"
           "printf 'deltaT = 1e-10\\nTime = 0.0900000001\\n'; sleep 60");
  EXPECT_EQ(failure(), (case_folder() / "log.multiphaseInterFoam").string() +
                           ": the run diverged at t = 0.09 s: the time step fell from 0.002 s to 1e-10 s; try another "
                           "cell size (--cell), or a smaller maxCo in system/controlDict and ./Allclean && ./Allrun");
}

TEST_F(FoamRunTest, EndsTheSolverWhenItIsAskedToStop) {
  stand_in("multiphaseInterFoam", "echo $$ > solver.pid; exec sleep 60");
  std::thread stop([&] {
    while (!fs::exists(case_folder() / "solver.pid")) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::raise(SIGTERM);
  });
  int signal = 0;
  try {
    run_foam(case_folder(), 0.1);
  } catch (const Interrupted& interrupted) {
    signal = interrupted.signal;
  }
  stop.join();
  EXPECT_EQ(signal, SIGTERM);
  std::ifstream stream(case_folder() / "solver.pid");
  pid_t solver = 0;
  stream >> solver;
  ASSERT_GT(solver, 0);
  // Once its parent is gone it is reaped elsewhere, which takes a moment.
  for (int i = 0; i < 100 && kill(solver, 0) == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_NE(kill(solver, 0), 0);
}

TEST_F(FoamRunTest, SaysHowToGetOpenFoam) {
  setenv("PATH", folder_.path().c_str(), 1);
  EXPECT_EQ(
      message_of<InputError>([] { require_openfoam(); }),
      "OpenFOAM is not installed (no blockMesh on PATH); install it with `apt-get install openfoam`, or leave the "
      "mesh model out");
}

}  // namespace
}  // namespace thalweg::foam
