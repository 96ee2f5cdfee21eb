// The answer of a run: deepest scour over time, and the band from runs beside it.
#include "postproc/scour_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/reader/case_file.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using manufactured::write_text;

ExtractionRun hole_that_fills_again() {
  ExtractionRun extraction;
  for (const auto& [time, depth] : {std::pair{0.0, 0.0}, {0.1, 0.012}, {0.2, 0.02}, {0.3, 0.015}}) {
    BedBalance balance;
    balance.scour = depth;
    balance.scour_at = {0.1 + time, 0.05, 0};
    balance.deposition = depth / 2;
    balance.eroded = depth / 10;
    extraction.balances.push_back({time, balance});
  }
  return extraction;
}

TEST(ScourSummary, TellsTheDeepestOverTimeAndThatOfTheEnd) {
  const auto answer = deepest_scour(hole_that_fills_again(), {});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->depth, 0.02);
  EXPECT_NEAR(answer->x, 0.3, 1e-12);
  EXPECT_EQ(answer->time, 0.2);
  EXPECT_EQ(answer->at_end, 0.015);
  EXPECT_TRUE(std::isnan(answer->bed_time));
  EXPECT_FALSE(deepest_scour({}, {})) << "no bed, no answer";
}

TEST(ScourSummary, OfASurfaceTheBedsOwnTimeCounts) {
  ScourRecord record;
  record.time = {10, 20, 30};
  record.water = {0.5, 1, 1.5};
  record.depth = {0.01, 0.03, 0.028};
  record.x = {0.1, 0.2, 0.3};
  record.y = {0, 0, 0};
  const auto answer = deepest_scour(hole_that_fills_again(), record);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->depth, 0.03);
  EXPECT_EQ(answer->x, 0.2);
  EXPECT_EQ(answer->bed_time, 20);
  EXPECT_EQ(answer->time, 1);
  EXPECT_EQ(bed_time_at(record, 0.4), 0);
  EXPECT_EQ(bed_time_at(record, 1.2), 20);
}

TEST(ScourSummary, TheBandIsTheLargestDifferenceOfRunsBesideAndOfEqualRuns) {
  const TemporaryFolder folder("band");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  const ScourSeries series = series_of(hole_that_fills_again());
  EXPECT_FALSE(band_of(run, series, {}, {}).is_known());

  Case coarse = read_case(run.resolved_case());
  coarse.numerics.spacing *= 2;
  write_case(run.coarser(2).resolved_case(), coarse);
  write_text(run.coarser(2).profiles() / "series.csv",
             "time [s],front [m],scour [m]\n0,0,0\n0.1,0,0.016\n0.15,0,0.017\n");
  // Up to 0.15 s, which both have: 12 mm here, 17 mm there.
  ScourBand band = band_of(run, series, {}, {});
  ASSERT_EQ(band.beside.size(), 1U);
  EXPECT_EQ(band.beside[0].label, "2 times the spacing (10 mm)");
  EXPECT_NEAR(band.half_width(), 0.005, 1e-12);
  EXPECT_TRUE(band.spacing_varied);
  band = band_of(run, series, {}, {{"free_surface", 0.1, 0.2}, {"bed", 0.1, 0.004}, {"bed", 0.2, 0.006}});
  EXPECT_NEAR(band.half_width(), 0.006, 1e-12) << "equal runs differ by more than the spacing";
}

}  // namespace
}  // namespace thalweg
