#include "postproc/scour_record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "common/csv.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class ScourRecordTest : public testing::Test {
 protected:
  ScourRecordTest() : folder_(fs::path(testing::TempDir()) / fmt::format("scour_record_{}", getpid())) {
    fs::create_directories(folder_);
    case_.model.sediment = SedimentModel::surface;
  }
  ~ScourRecordTest() override { fs::remove_all(folder_); }

  /// A hole that grows as 0.1 m (1 - exp(-t/20 s)) until the time `end` [s] of the bed; every value stands in two rows.
  fs::path history(double end) const {
    const fs::path file = folder_ / "history.csv";
    std::ofstream to(file);
    to << "time [s],bed_time [s],bed_scour [m],bed_scour_x [m],bed_scour_y [m],bed_fed [m^3],bed_left [m^3],bed_steps "
          "[-],"
          "bed_unsettled [-]\n";
    for (int row = 0; row <= 100; ++row) {
      const double t = end * (row / 2) / 50;
      to << fmt::format("{},{},{},0.25,0.1,1e-4,2e-4,{},1\n", 0.1 * row, t, 0.1 * (1 - std::exp(-t / 20)), row / 2);
    }
    return file;
  }

  fs::path folder_;
  Case case_;
};

TEST_F(ScourRecordTest, TellsAnEquilibriumThatWasReached) {
  const ScourRecord record = read_scour(case_, history(60));
  ASSERT_EQ(record.time.size(), 50U);  // the start and the rows that say the same again are left out
  EXPECT_NEAR(record.depth.back(), 0.1 * (1 - std::exp(-3)), 1e-5);
  EXPECT_EQ(record.x.back(), 0.25);
  EXPECT_EQ(record.y.back(), 0.1);
  EXPECT_EQ(record.steps, 50);
  EXPECT_EQ(record.unsettled, 1);
  EXPECT_NEAR(record.water_time, 10, 1e-9);
  ASSERT_TRUE(record.fit.has_reached());
  EXPECT_NEAR(record.fit.equilibrium, 0.1, 1e-4);
  EXPECT_NEAR(record.fit.time_scale, 20, 0.05);
  write_scour(folder_ / "scour.csv", record);
  const CsvTable table = CsvTable::read(folder_ / "scour.csv");
  EXPECT_NEAR(table.numbers("fit", "m").back(), record.depth.back(), 1e-5);
}

TEST_F(ScourRecordTest, TellsNoneThatIsFarAway) {
  const ScourRecord record = read_scour(case_, history(15));
  EXPECT_FALSE(record.fit.has_reached());
  write_scour(folder_ / "scour.csv", record);
  EXPECT_EQ(CsvTable::read(folder_ / "scour.csv").numbers("depth", "m").size(), 51U) << "and the start";
  std::ifstream file(folder_ / "scour.csv");
  std::string heading;
  std::getline(file, heading);
  EXPECT_EQ(heading, "time [s],depth [m]");
}

TEST_F(ScourRecordTest, ReadsRunsBesideAtTheTimeThatBothHave) {
  const ScourRecord main = read_scour(case_, history(60));
  const RunFolder run{folder_};
  EXPECT_TRUE(read_scour_checks(run, main).empty());
  const RunFolder slower = run.slower(2);
  fs::create_directories(slower.root);
  // Half as deep, until 40 s of the bed.
  std::ofstream to(slower.history());
  to << "time [s],bed_time [s],bed_scour [m],bed_scour_x [m],bed_scour_y [m],bed_fed [m^3],bed_left [m^3],bed_steps "
        "[-],bed_unsettled [-]\n";
  for (int row = 0; row <= 100; ++row) {
    const double t = 0.4 * row;
    to << fmt::format("{},{},{},0.25,0.1,0,0,{},0\n", t, t, 0.05 * (1 - std::exp(-t / 20)), row);
  }
  to.close();
  std::ofstream(slower.resolved_case()) << R"([case]
name = "slower"
dimension = 2
[domain]
from = ["0 m", "-0.1 m"]
to = ["0.2 m", "0.2 m"]
periodic = ["x"]
[[shape]]
name = "floor"
kind = "box"
role = "wall"
from = ["0 m", "-0.1 m"]
to = ["0.2 m", "-0.05 m"]
[[shape]]
name = "bed"
kind = "box"
role = "sediment"
from = ["0 m", "-0.05 m"]
to = ["0.2 m", "0 m"]
[[shape]]
name = "water"
kind = "box"
role = "water"
from = ["0 m", "0 m"]
to = ["0.2 m", "0.1 m"]
[materials.water]
density = "1000 kg/m^3"
viscosity = "0.001 Pa s"
[materials.sand]
grain_density = "2650 kg/m^3"
grain_diameter = "1 mm"
porosity = 0.4
friction_angle = "32 deg"
[model]
sediment = "surface"
[surface_bed]
factor = 5
[numerics]
spacing = "10 mm"
[output]
end = "1 s"
interval = "0.5 s"
)";
  const std::vector<ScourCheck> checks = read_scour_checks(run, main);
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks[0].label, "factor 5");
  EXPECT_NEAR(checks[0].time, 40, 1e-9);
  EXPECT_NEAR(checks[0].depth, 0.05 * (1 - std::exp(-2)), 1e-9);
  EXPECT_NEAR(checks[0].of_main, 0.1 * (1 - std::exp(-2)), 3e-4);
}

TEST_F(ScourRecordTest, IsEmptyForOtherBeds) {
  const fs::path file = history(60);
  case_.model.sediment = SedimentModel::three_state;
  EXPECT_TRUE(read_scour(case_, file).time.empty());
  case_.model.sediment = SedimentModel::surface;
  EXPECT_TRUE(read_scour(case_, folder_ / "absent.csv").time.empty());
}

}  // namespace
}  // namespace thalweg
