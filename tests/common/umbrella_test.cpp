#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "case/reader/case_file.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/process.hpp"
#include "common/run_folder.hpp"
#include "common/warnings.hpp"

// The program `thalweg` is copied into a folder beside small scripts that take the names of the stages and record how
// they were called; what the stages themselves do is tested elsewhere.
namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class Umbrella : public ::testing::Test {
 protected:
  Umbrella() {
    fs::remove_all(folder);
    fs::create_directories(folder / "bin");
    fs::copy_file(THALWEG_PROGRAM, folder / "bin/thalweg");
    for (const char* stage : {"gencase", "solver", "foam", "postproc"}) install(stage, 0);
    fs::copy_file(source / "tests/case/good_case.toml", folder / "case.toml");
  }
  ~Umbrella() override { fs::remove_all(folder); }

  void install(const std::string& stage, int status, const std::string& more = "") const {
    const fs::path program = folder / "bin" / ("thalweg-" + stage);
    const std::string makes =
        stage == "gencase" ? "case \"$*\" in *--check*) ;; *) /bin/mkdir -p \"$3\" ;; esac\n" : "";
    std::ofstream(program) << "#!/bin/sh\necho " << stage << " \"$@\" >> calls\n"
                           << makes << more << "\nexit " << status << "\n";
    fs::permissions(program, fs::perms::owner_all);
  }
  void install_openfoam() const {
    fs::create_directories(folder / "openfoam");
    std::ofstream(folder / "openfoam/blockMesh") << "#!/bin/sh\n";
    fs::permissions(folder / "openfoam/blockMesh", fs::perms::owner_all);
  }

  // Runs `thalweg arguments` in the folder, with a PATH on which only install_openfoam() puts OpenFOAM.
  int thalweg(const std::string& arguments) const {
    const std::string command = "cd '" + folder.string() + "' && PATH='" + (folder / "openfoam").string() +
                                "' bin/thalweg " + arguments + " > out.txt 2> err.txt";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] std::string calls() const { return text_of(folder / "calls"); }
  [[nodiscard]] std::string output() const { return text_of(folder / "out.txt"); }
  [[nodiscard]] std::string errors() const { return text_of(folder / "err.txt"); }

  const fs::path source = THALWEG_SOURCE_DIR;
  const fs::path folder = fs::path(::testing::TempDir()) /
                          (std::string("umbrella ") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Umbrella, RunsTheStagesInOrder) {
  install_openfoam();
  EXPECT_EQ(thalweg("run case.toml --out 'my run' --set numerics.spacing='4 mm' --set output.end='2 s' --threads 2"),
            0);
  EXPECT_EQ(calls(),
            "foam case.toml --check --set numerics.spacing=4 mm --set output.end=2 s\n"
            "gencase case.toml --out my run --set numerics.spacing=4 mm --set output.end=2 s\n"
            "solver my run --threads 2\n"
            "foam case.toml --out my run --set numerics.spacing=4 mm --set output.end=2 s\n"
            "postproc my run --report\n");
  EXPECT_THAT(output(), HasSubstr("report: my run/report/index.html\n"));
  EXPECT_EQ(errors(), "");
}

TEST_F(Umbrella, PassesOnHowMuchToSay) {
  EXPECT_EQ(thalweg("run case.toml --no-foam --quiet"), 0);
  EXPECT_EQ(
      calls(),
      "gencase case.toml --out out/flume --quiet\nsolver out/flume --quiet\npostproc out/flume --report --quiet\n");
  EXPECT_EQ(output(), "");
}

// The stages' own lines must not get between the brackets.
TEST_F(Umbrella, TellsTheRunInJson) {
  install("solver", 1,
          "echo said; echo '2026-11-27 20:00:00.000 solver error: it diverged; use less' >> \"$1/log.txt\"");
  EXPECT_EQ(thalweg("run case.toml --no-foam --json"), 1);
  const auto told = nlohmann::json::parse(output());
  EXPECT_EQ(told["status"], 1);
  EXPECT_EQ(told["stages"].size(), 3U) << "a run that failed has a report too";
  EXPECT_EQ(told["stages"][1]["stage"], "solver");
  EXPECT_EQ(told["errors"][0]["cure"], "use less");
  EXPECT_THAT(errors(), HasSubstr("said\n"));
}

TEST_F(Umbrella, TellsWrongArgumentsInJson) {
  EXPECT_EQ(thalweg("run nowhere --json"), 2);
  const auto told = nlohmann::json::parse(output());
  EXPECT_EQ(told["status"], 2);
  EXPECT_THAT(told["errors"][0]["message"].get<std::string>(), HasSubstr("there is no such file or folder"));
}

TEST_F(Umbrella, NamesTheRunAfterTheCase) {
  EXPECT_EQ(thalweg("run case.toml --no-foam"), 0);
  EXPECT_EQ(calls(), "gencase case.toml --out out/flume\nsolver out/flume\npostproc out/flume --report\n");
  EXPECT_THAT(output(), Not(HasSubstr("OpenFOAM")));
}

TEST_F(Umbrella, LeavesTheMeshModelOutWithoutOpenFoamAndSaysHowToGetIt) {
  EXPECT_EQ(thalweg("run case.toml"), 0);
  EXPECT_THAT(calls(), Not(HasSubstr("foam ")));
  EXPECT_THAT(output(), HasSubstr("foam: left out: OpenFOAM is not installed; get it with: apt-get install"));
  EXPECT_THAT(warnings_of_programs({folder / "out/flume"}),
              ElementsAre("foam: left out: OpenFOAM is not installed; get it with: apt-get install openfoam"));
}

// Before the particles, which may take hours; and the report says why.
TEST_F(Umbrella, LeavesTheMeshModelOutWhereTheSceneHasNone) {
  install_openfoam();
  install("foam", 2, "echo 'error: case.toml:9: shape \"gate\" is a prism' >&2");
  EXPECT_EQ(thalweg("run case.toml"), 0);
  EXPECT_EQ(
      calls(),
      "foam case.toml --check\ngencase case.toml --out out/flume\nsolver out/flume\npostproc out/flume --report\n");
  EXPECT_THAT(output(), HasSubstr("foam: left out: case.toml:9: shape \"gate\" is a prism\n"));
  EXPECT_THAT(warnings_of_programs({folder / "out/flume"}),
              ElementsAre("foam: left out: case.toml:9: shape \"gate\" is a prism"));
}

TEST_F(Umbrella, ReportsWithoutAMeshModelThatFailsAndEndsWithOne) {
  install_openfoam();
  install("foam", 1, "[ \"$2\" = --check ] && exit 0");
  EXPECT_EQ(thalweg("run case.toml"), 1);
  EXPECT_THAT(calls(), ::testing::EndsWith("foam case.toml --out out/flume\npostproc out/flume --report\n"));
  EXPECT_THAT(warnings_of_programs({folder / "out/flume"}),
              ElementsAre("foam: failed with status 1; the report does without what is missing"));
}

TEST_F(Umbrella, StopsAtTheFirstStageThatFails) {
  install("solver", 130);
  EXPECT_EQ(thalweg("run case.toml"), 130);
  EXPECT_EQ(calls(), "gencase case.toml --out out/flume\nsolver out/flume\n");
  EXPECT_THAT(errors(), HasSubstr("solver ended with status 130"));
}

TEST_F(Umbrella, MakesTheReportWithoutAMeshModelThatFails) {
  install_openfoam();
  install("foam", 1);
  EXPECT_EQ(thalweg("run case.toml"), 1);
  EXPECT_THAT(calls(), HasSubstr("postproc out/flume --report\n"));
  EXPECT_THAT(output(), HasSubstr("== foam failed; the report does without it\n"));
}

// kill -9 leaves the umbrella no time to end its stage, which gets SIGTERM all the same.
TEST_F(Umbrella, TakesItsStageAlongWhenItIsKilled) {
  std::ofstream(folder / "bin/thalweg-solver") << "#!/bin/sh\ntrap 'echo asked > asked; exit' TERM\necho $$ > part\n"
                                                  "/bin/mv part started\nwhile :; do /bin/sleep 0.01; done\n";
  ChildProcess umbrella({(folder / "bin/thalweg").string(), "run", "case.toml", "--no-foam"},
                        {.log = folder / "log", .folder = folder});
  const auto appears = [&](const char* name) {
    for (int i = 0; i < 1000 && !fs::exists(folder / name); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return fs::exists(folder / name);
  };
  ASSERT_TRUE(appears("started")) << text_of(folder / "log");
  kill(umbrella.id(), SIGKILL);
  EXPECT_EQ(umbrella.wait(), 128 + SIGKILL);
  EXPECT_TRUE(appears("asked"));
}

TEST_F(Umbrella, StartsNothingWhenTheCaseIsWrongOrAStageIsAbsent) {
  EXPECT_EQ(thalweg("run case.toml --set numerics.spacing=4"), 2);
  EXPECT_THAT(errors(), HasSubstr("error: --set numerics.spacing=4: numerics.spacing = 4 has no unit"));
  fs::remove(folder / "bin/thalweg-postproc");
  EXPECT_EQ(thalweg("run case.toml"), 2);
  EXPECT_EQ(calls(), "");
}

TEST_F(Umbrella, AsksBeforeItReplacesARun) {
  const RunFolder run{folder / "out" / "flume"};
  write_series(run.snapshot_series(), {{0, "snapshots/s00000.vtp"}, {0.25, "snapshots/s00001.vtp"}});
  EXPECT_EQ(thalweg("run case.toml"), 2);
  EXPECT_THAT(errors(), HasSubstr("holds a run up to t = 0.25 s; continue it with --resume, replace it with --force"));
  EXPECT_EQ(calls(), "");
  EXPECT_EQ(thalweg("run case.toml --force"), 0);
  EXPECT_EQ(calls(),
            "gencase case.toml --out out/flume --force\nsolver out/flume --force\npostproc out/flume --report\n");
}

TEST_F(Umbrella, ResumesWhatIsNotDone) {
  const RunFolder run{folder / "out" / "flume"};
  write_series(run.snapshot_series(), {{0.25, "snapshots/s00001.vtp"}});
  write_case(run.resolved_case(), read_case(folder / "case.toml"));
  std::ofstream(run.particles()) << "filled";
  EXPECT_EQ(thalweg("run case.toml --resume"), 0);
  EXPECT_EQ(calls(), "solver out/flume --restart latest\npostproc out/flume --report\n");
  EXPECT_EQ(thalweg("run case.toml --resume --set numerics.cfl=0.3"), 2);
  EXPECT_THAT(errors(), HasSubstr("filled from another case: numerics.cfl 0.5 -> 0.3; give the same case"));
}

TEST_F(Umbrella, FindsTheProgramsByName) {
  install("gencase", 7);
  EXPECT_EQ(thalweg("gencase case.toml --check"), 7);
  EXPECT_EQ(calls(), "gencase case.toml --check\n");
  EXPECT_EQ(thalweg("gencas"), 2);
  EXPECT_EQ(errors(), "error: thalweg: there is no command gencas; did you mean gencase?\n");
  EXPECT_EQ(thalweg(""), 2);
  EXPECT_EQ(errors(), "error: thalweg: no command is given; see thalweg help\n");
  EXPECT_EQ(thalweg("--help"), 0);
  EXPECT_THAT(output(), HasSubstr("\n  postproc DIR "));
  const std::string overview = output();
  EXPECT_EQ(thalweg("help"), 0);
  EXPECT_EQ(output(), overview);
  EXPECT_LT(overview.find("  gencase "), overview.find("  solver ")) << "the order of use";
  EXPECT_LT(overview.find("  solver "), overview.find("  explain "));
  EXPECT_EQ(thalweg("help gencas"), 2);
  EXPECT_EQ(thalweg("help run"), 0);
  EXPECT_THAT(output(), HasSubstr("--resume"));
  EXPECT_EQ(thalweg("run case.toml --nonsense"), 2);
  EXPECT_THAT(errors(), HasSubstr("error: command line: "));
}

TEST_F(Umbrella, ExplainsKeys) {
  EXPECT_EQ(thalweg("explain cfl"), 0);
  EXPECT_THAT(output(), HasSubstr("numerics.cfl\n  number, 0.01 to 0.8; default 0.5\n"));
  EXPECT_EQ(thalweg("explain scour depth"), 0);
  EXPECT_THAT(output(), HasSubstr("model.sediment\n"));
  EXPECT_EQ(thalweg("explain --markdown"), 0);
  EXPECT_EQ(output(), text_of(source / "docs/case-file.md"));
  EXPECT_EQ(thalweg("explain nonsense_key"), 2);
}

TEST_F(Umbrella, SaysWhatIsInARun) {
  const RunFolder run{folder / "run"};
  ParticleSet particles;
  particles.info = {"flume", "0.1.0", "00ff", 2, 0.005, 0.0075, 0.25, 500};
  particles.id = {1, 2, 3};
  particles.type = {ParticleType::wall, ParticleType::water, ParticleType::sediment};
  particles.state = {SedimentState::none, SedimentState::none, SedimentState::deposit};
  particles.position = {Vec3(-1, 0, 0), Vec3(0, 0, 0.25), Vec3(1.5, 0, 0.06)};
  particles.velocity = {Eigen::Vector3f::Zero(), Eigen::Vector3f(3, 0, 4), Eigen::Vector3f::Zero()};
  particles.mass = {0.0F, 0.025F, 0.03125F};
  write_particles(run.particles(), particles, PositionPrecision::double_precision);
  write_series(run.snapshot_series(), {{0, "snapshots/s00000.vtp"}, {0.25, "snapshots/s00001.vtp"}});

  EXPECT_EQ(thalweg("info run"), 0);
  EXPECT_THAT(output(), HasSubstr("3 particles of case \"flume\", 2-D"));
  EXPECT_THAT(output(), HasSubstr("time 0.25 s, step 500, spacing 5 mm, smoothing length 7.5 mm"));
  EXPECT_THAT(output(), HasSubstr("  water                  1  2.5e-05 m^2  0.025 kg/m\n"));
  EXPECT_THAT(output(), HasSubstr("  sediment               1  2.5e-05 m^2  0.03125 kg/m\n"));
  // 3 particles of 500 and 120 bytes.
  EXPECT_THAT(output(), HasSubstr("solver: about 1.86 kB on a CPU; 2.4 kB of a GPU's and 360 B of the host's\n"));
  EXPECT_THAT(output(), HasSubstr("  sediment, deposit: 1\n"));
  EXPECT_THAT(output(), HasSubstr("  x from -1 m to 1.5 m\n  z from 0 m to 0.25 m\n  speed 0 to 5 m/s\n"));
  EXPECT_THAT(output(), HasSubstr("snapshots.pvd: 2 snapshots, 0 s to 0.25 s; 2 of the files are missing\n"));

  EXPECT_EQ(thalweg("info bin"), 2);
  EXPECT_EQ(errors(), "error: bin: the folder holds no run; name one that thalweg gencase has filled\n");
  EXPECT_EQ(thalweg("info absent.vtp"), 2);
}

}  // namespace
}  // namespace thalweg
