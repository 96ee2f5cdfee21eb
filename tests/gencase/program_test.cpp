#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/case_file.hpp"
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

TEST_F(Program, EveryCaseOfTheProjectIsSound) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(CASES)) {
    if (!fs::exists(entry.path() / "case.toml")) continue;
    ++cases;
    EXPECT_EQ(run("'" + entry.path().string() + "' --check"), 0) << entry.path() << ": " << complained_;
    EXPECT_EQ(complained_, "") << entry.path();
  }
  EXPECT_GE(cases, 3);
}

}  // namespace
}  // namespace thalweg
