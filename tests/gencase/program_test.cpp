#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "case/reader/case_file.hpp"
#include "common/io/particle_file.hpp"
#include "common/run_folder.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class Program : public testing::Test {
 protected:
  Program() : folder_(fs::temp_directory_path() / ("gencase_test_" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Program() override { fs::remove_all(folder_); }

  /// Runs thalweg-gencase; returns its exit status and keeps what it printed.
  int run(const std::string& arguments) {
    const fs::path out = folder_ / "stdout";
    const fs::path err = folder_ / "stderr";
    const int status = std::system(("cd '" + folder_.string() + "' && '" GENCASE "' " + arguments + " >'" +
                                    out.string() + "' 2>'" + err.string() + "'")
                                       .c_str());
    printed_ = read(out);
    complained_ = read(err);
    return WEXITSTATUS(status);
  }
  static std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  fs::path folder_;
  std::string printed_;
  std::string complained_;
};

TEST_F(Program, WritesParticlesAndResolvedCase) {
  ASSERT_EQ(run(CASES "/louvain --out run"), 0) << complained_;
  EXPECT_EQ(complained_, "");
  const RunFolder run_folder{folder_ / "run"};
  const ParticleSet set = read_particles(run_folder.particles());
  const auto counts = count_by_type(set);
  EXPECT_EQ(counts[static_cast<std::size_t>(ParticleType::sediment)], 500 * 12);  // 2.5 m x 0.06 m at 5 mm
  EXPECT_EQ(counts[static_cast<std::size_t>(ParticleType::water)], 200 * 20);
  EXPECT_EQ(counts[static_cast<std::size_t>(ParticleType::wall)], 506 * 3 + 2 * 3 * 60);
  EXPECT_EQ(set.info.case_name, "louvain");
  EXPECT_DOUBLE_EQ(set.info.spacing, 0.005);
  EXPECT_DOUBLE_EQ(set.info.smoothing_length, 0.0075);
  EXPECT_EQ(set.normal.size(), set.size());
  EXPECT_EQ(set.scalars.at("WallDistance").size(), set.size());

  const Case resolved = read_case(run_folder.resolved_case());
  EXPECT_DOUBLE_EQ(resolved.numerics.maximum_speed, 2);
  EXPECT_EQ(set.info.case_hash, hash_of(resolved));
}

TEST_F(Program, ResolvesTheMaximumSpeedTheCaseLeavesOpen) {
  ASSERT_EQ(run(CASES "/louvain --out run --set numerics.maximum_speed='\"0 m/s\"'"), 0) << complained_;
  const Case resolved = read_case(RunFolder{folder_ / "run"}.resolved_case());
  EXPECT_NEAR(resolved.numerics.maximum_speed, 2 * std::sqrt(9.81 * 0.16), 1e-12);
}

TEST_F(Program, CheckWritesNothing) {
  ASSERT_EQ(run(CASES "/louvain --check --out run"), 0) << complained_;
  EXPECT_FALSE(fs::exists(folder_ / "run"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_NE(printed_.find("checked only: nothing written"), std::string::npos);
  EXPECT_NE(printed_.find("sediment"), std::string::npos);
}

TEST_F(Program, DefaultFolderBearsTheCasesName) {
  ASSERT_EQ(run(CASES "/louvain --set numerics.spacing='\"20 mm\"'"), 0) << complained_;
  EXPECT_TRUE(fs::exists(folder_ / "out" / "louvain" / "particles.vtp"));
}

TEST_F(Program, BadInputEndsWithStatusTwoAndOneLine) {
  EXPECT_EQ(run(CASES "/louvain --check --set domain.to='[\"1.505 m\", \"0.5 m\"]'"), 2);
  EXPECT_EQ(complained_.rfind("error: ", 0), 0U) << complained_;
  EXPECT_NE(complained_.find("case.toml:15: shape \"flume\" has "), std::string::npos) << complained_;
  EXPECT_EQ(std::count(complained_.begin(), complained_.end(), '\n'), 1);
}

TEST_F(Program, RefusalLeavesAPictureOfTheDefectsAndNoParticles) {
  EXPECT_EQ(run(BAD_GEOMETRY "/scene.toml --out run --set shape.pier.file=two_holes.off"), 2);
  EXPECT_TRUE(fs::exists(folder_ / "run" / "pier.defects.vtp"));
  EXPECT_NE(complained_.find("the places are in run/pier.defects.vtp"), std::string::npos) << complained_;
  EXPECT_FALSE(fs::exists(RunFolder{folder_ / "run"}.particles()));
  EXPECT_EQ(run(BAD_GEOMETRY "/scene.toml --check --out other --set shape.pier.file=two_holes.off"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "other"));
}

TEST_F(Program, RepairSaysWhatItDidAndTheResolvedCaseRemembers) {
  const std::string turned = BAD_GEOMETRY "/scene.toml --set shape.pier.file=turned.off";
  EXPECT_EQ(run(turned + " --check"), 2);
  ASSERT_EQ(run(turned + " --repair --out run"), 0) << complained_;
  EXPECT_NE(printed_.find("turned.off repaired: 1 face turned"), std::string::npos) << printed_;
  EXPECT_TRUE(read_case(RunFolder{folder_ / "run"}.resolved_case()).shapes[1].repair);
}

TEST_F(Program, WarnsOfALeakAndDrawsTheWay) {
  std::ofstream(folder_ / "case.toml") << R"([case]
name = "drain"
[domain]
from = ["-0.2 m", "-0.2 m"]
to = ["1 m", "1 m"]
[[shape]]
name = "tank"
kind = "box"
role = "wall"
side = "outside"
open = ["+z"]
from = ["0 m", "0 m"]
to = ["0.5 m", "0.3 m"]
[[shape]]
name = "drain"
kind = "box"
role = "empty"
from = ["0.2 m", "-0.1 m"]
to = ["0.22 m", "0 m"]
[[shape]]
name = "water"
kind = "level"
role = "water"
level = "0.1 m"
[numerics]
spacing = "1 cm"
[output]
end = "1 s"
)";
  ASSERT_EQ(run(". --out run"), 0) << complained_;
  EXPECT_NE(complained_.find("fluid at rest can leave the containers"), std::string::npos) << complained_;
  EXPECT_TRUE(fs::exists(folder_ / "run" / "leak.vtp"));
}

TEST_F(Program, LouvainInSpaceHasThePapersFluidCounts) {
  // Zhang, Xiong & Liu (2024): 500 x 50 x 50 particles of water and 1000 x 50 x 30 of sediment at 2 mm.
  ASSERT_EQ(run(CASES "/louvain3d --check --set numerics.spacing='2 mm'"), 0) << complained_;
  EXPECT_NE(printed_.find("water               1250000 particles"), std::string::npos) << printed_;
  EXPECT_NE(printed_.find("sediment            1500000 particles"), std::string::npos) << printed_;
}

TEST_F(Program, ThePiersFileIsWhatItsScriptMakes) {
  ASSERT_EQ(std::system(("'" CASES "/pier/make_pier.py' '" + (folder_ / "pier.stl").string() + "'").c_str()), 0);
  EXPECT_EQ(read(folder_ / "pier.stl"), read(fs::path(CASES) / "pier" / "pier.stl"));
}

TEST_F(Program, EverySceneOfTheMeasurementsIsSound) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(CASES "/../bench/speed_vs_error/scenes")) {
    if (!fs::exists(entry.path() / "case.toml")) continue;
    ++scenes;
    EXPECT_EQ(run("'" + entry.path().string() + "' --check"), 0) << entry.path() << ": " << complained_;
  }
  EXPECT_GE(scenes, 5);
}

TEST_F(Program, EveryCaseOfTheProjectIsSound) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(CASES)) {
    if (!fs::exists(entry.path() / "case.toml")) continue;
    ++cases;
    EXPECT_EQ(run("'" + entry.path().string() + "' --check"), 0) << entry.path() << ": " << complained_;
    // A tank that was built and measured fits no lattice.
    if (entry.path().filename() == "spheric02") {
      complained_ = std::regex_replace(complained_, std::regex("warning: .* off the lattice .*\n"), "");
    }
    EXPECT_EQ(complained_, "") << entry.path();
  }
  EXPECT_GE(cases, 5);
}

}  // namespace
}  // namespace thalweg
