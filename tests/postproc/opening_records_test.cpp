#include "postproc/opening_records.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/postproc/synthetic_run.hpp"

// Hydrographs out of history.csv.
namespace thalweg {
namespace {

using manufactured::contents_of;
using manufactured::TemporaryFolder;
using manufactured::write_text;

Case with_openings() {
  Case of;
  of.water.density = 1000;
  of.inlets.emplace_back().name = "west";
  of.outlets.emplace_back().name = "east";
  return of;
}

TEST(OpeningRecords, AreRatesOverWindows) {
  // 200 rows, one every 0.1 s; 40 kg/s enter, 30 kg/s leave, and the level rises by 1 mm a second.
  const TemporaryFolder folder("openings");
  std::string history =
      "time [s],west_water [kg],west_sediment [kg],west_level [m],east_water [kg],east_sediment [kg],east_level [m]\n";
  for (int row = 0; row <= 200; ++row) {
    const double t = 0.1 * row;
    history += std::to_string(t) + "," + std::to_string(40 * t) + ",0," + std::to_string(0.1 + 1e-3 * t) + "," +
               std::to_string(-30 * t) + ",-2,\n";
  }
  write_text(folder.path() / "history.csv", history);
  const OpeningRecords records = read_openings(with_openings(), folder.path() / "history.csv");
  ASSERT_EQ(records.openings.size(), 2U);
  ASSERT_EQ(records.time.size(), 50U);
  const OpeningRecord& west = records.openings[0];
  const OpeningRecord& east = records.openings[1];
  EXPECT_TRUE(west.enters);
  EXPECT_FALSE(east.enters);
  for (std::size_t n = 0; n < records.time.size(); ++n) {
    EXPECT_NEAR(west.rate[n], 0.04, 1e-6);
    EXPECT_NEAR(east.rate[n], -0.03, 1e-6);
    EXPECT_NEAR(west.level[n], 0.1 + 1e-3 * records.time[n], 1e-4);
    EXPECT_TRUE(std::isnan(east.level[n]));
  }
  EXPECT_NEAR(west.mean_rate, 0.04, 1e-6);
  EXPECT_NEAR(west.mean_level, 0.115, 1e-4);
  EXPECT_NEAR(west.water, 800, 1e-6);
  EXPECT_EQ(east.sediment, -2);

  write_openings(folder.path() / "openings.csv", records, 2);
  EXPECT_THAT(contents_of(folder.path() / "openings.csv"),
              testing::StartsWith("time [s],west_rate [m^2/s],west_level [m],east_rate [m^2/s],east_level [m]\n"));
}

TEST(OpeningRecords, AreNoneWithoutOpeningsOrRows) {
  const TemporaryFolder folder("no_openings");
  EXPECT_TRUE(read_openings(Case{}, folder.path() / "history.csv").openings.empty());
  EXPECT_TRUE(read_openings(with_openings(), folder.path() / "history.csv").openings.empty());
}

}  // namespace
}  // namespace thalweg
