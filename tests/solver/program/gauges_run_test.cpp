#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/solver/program/broken_run.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// The Louvain case with gauges in the tank, at the dry end and behind the gate.
class GaugedCase {
 public:
  explicit GaugedCase(const std::string& name)
      : folder_(fs::path(testing::TempDir()) / (name + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "case.toml") << contents_of(fs::path(THALWEG_SOURCE_DIR) / "cases" / "louvain" /
                                                        "case.toml")
                                         << R"(
[[gauge]]
name = "tank"
kind = "water level"
at = ["-0.5 m", "0 m"]
[[gauge]]
name = "p"
kind = "pressure"
at = ["-0.5 m", "0.1 m"]
[[gauge]]
name = "air"
kind = "velocity"
at = ["0.6 m", "0.18 m"]
[[gauge]]
name = "gate"
kind = "flux"
from = ["0 m", "0 m"]
to = ["0 m", "0.3 m"]
)";
  }
  ~GaugedCase() { fs::remove_all(folder_); }
  GaugedCase(const GaugedCase&) = delete;
  GaugedCase& operator=(const GaugedCase&) = delete;
  [[nodiscard]] std::string path() const { return folder_.string(); }

 private:
  fs::path folder_;
};

const std::vector<std::string> brief = {"numerics.spacing=\"20 mm\"", "output.end=\"0.1 s\"",
                                        "output.interval=\"0.05 s\"", "output.gauge_interval=\"0.01 s\"",
                                        "compare.times=[]"};

TEST(GaugesOfARun, AreWrittenWithoutSnapshotsAndContinuedAsOneRun) {
  const GaugedCase gauged("gauged");
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(gauged.path(), brief, "0.05 s", ends));
  const RunFolder& straight = ends.straight_run.folder();
  const CsvTable table = CsvTable::read(straight.gauges());
  ASSERT_EQ(table.rows(), 11U);  // every 0.01 s from 0 to 0.1 s
  // 0.1 m of water on 0.06 m of bed at the start, to a tenth of the spacing; the flume is still where the wave is not.
  EXPECT_NEAR(table.numbers("tank.level", "m").front(), 0.16, 0.002);
  EXPECT_NEAR(table.numbers("p.pressure", "Pa").front(), 9810 * 0.06, 0.05 * 9810 * 0.06);
  EXPECT_THAT(table.texts("air.velocity_x"), testing::Each(""));
  EXPECT_THAT(table.texts("note"), testing::Each("air: no fluid in reach"));
  // The tank empties: by Ritter (1892) with 8/27 c h = 0.029 m^2/s over a fixed bed.
  EXPECT_GT(table.numbers("gate.water", "m^2/s").back(), 0.01);
  EXPECT_LT(table.numbers("gate.water", "m^2/s").back(), 0.06);
  EXPECT_EQ(contents_of(ends.broken_run.folder().gauges()), contents_of(straight.gauges()));
}

TEST(GaugesOfARun, AreAbsentWithoutGauges) {
  test::CaseRun run("no_gauges");
  run.fill("louvain", {"numerics.spacing=\"20 mm\"", "output.end=\"0.01 s\"", "compare.times=[]"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_FALSE(fs::exists(run.folder().gauges()));
}

}  // namespace
}  // namespace thalweg
