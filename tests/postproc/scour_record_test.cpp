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
  EXPECT_EQ(record.at[0], 0.25);
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
  EXPECT_EQ(CsvTable::read(folder_ / "scour.csv").numbers("depth", "m").size(), 50U);
  std::ifstream file(folder_ / "scour.csv");
  std::string heading;
  std::getline(file, heading);
  EXPECT_EQ(heading, "time [s],depth [m]");
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
