#include "postproc/postprocess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/csv.hpp"
#include "common/profile.hpp"
#include "common/warnings.hpp"
#include "postproc/profile_set.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using manufactured::contents_of;
using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using manufactured::write_text;
using testing::HasSubstr;

TEST(Postprocess, SaysPlainlyThatAReferenceSlotIsEmpty) {
  const TemporaryFolder folder("empty_reference");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  testing::internal::CaptureStdout();
  EXPECT_EQ(postprocess({synthetic.folder().root, {}, false}), Exit::done);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_THAT(said, HasSubstr("no measured profiles: "));
  EXPECT_THAT(said, HasSubstr("reference is empty\n"));
  EXPECT_FALSE(fs::exists(synthetic.folder().report() / "index.html"));
  EXPECT_TRUE(fs::exists(synthetic.folder().report() / "errors.csv"));
}

TEST(Postprocess, NamesDamagedSnapshotsSkipsThemAndEndsWithOne) {
  const TemporaryFolder folder("damaged");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  fs::resize_file(run.snapshots() / "s00005.vtp", 5000);
  testing::internal::CaptureStderr();
  EXPECT_EQ(postprocess({run.root, {}, false}), Exit::run_failed);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("skipped: " + (run.snapshots() / "s00005.vtp").string()));
  EXPECT_THAT(said, HasSubstr("no snapshot at t = 0.25 s"));
  EXPECT_FALSE(fs::exists(run.profiles() / "t0.250.csv"));
  EXPECT_TRUE(fs::exists(run.profiles() / "t0.500.csv"));

  // The same without the series file, then with one cut off: the times come from the snapshots themselves.
  for (const bool cut : {false, true}) {
    if (cut) {
      write_text(run.snapshot_series(), "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Coll");
    } else {
      fs::remove(run.snapshot_series());
    }
    fs::remove(run.profiles() / "t0.500.csv");
    testing::internal::CaptureStderr();
    EXPECT_EQ(postprocess({run.root, {}, false}), Exit::run_failed);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("the times were taken from the files in"));
    EXPECT_TRUE(fs::exists(run.profiles() / "t0.500.csv"));
  }
}

TEST(Postprocess, AnIntactRunWithoutSeriesFileIsNoFailure) {
  const TemporaryFolder folder("no_series");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  fs::remove(synthetic.folder().snapshot_series());
  EXPECT_EQ(postprocess({synthetic.folder().root, {}, false}), Exit::done);
}

TEST(Postprocess, AFolderWithoutARunIsWrongInputWithACure) {
  const TemporaryFolder folder("nothing");
  const auto complaint = [&](const fs::path& path) {
    try {
      postprocess({path, {}, false});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no InputError");
  };
  EXPECT_THAT(complaint(folder.path() / "none"), HasSubstr("there is no such folder"));
  EXPECT_THAT(complaint(folder.path()), HasSubstr("thalweg-gencase"));
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  fs::remove_all(synthetic.folder().snapshots());
  fs::remove(synthetic.folder().snapshot_series());
  EXPECT_THAT(complaint(folder.path()), HasSubstr("compute them with thalweg-solver"));
}

TEST(Postprocess, WithoutGnuplotSaysWhatToInstallAndWritesTheRest) {
  const TemporaryFolder folder("no_gnuplot");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  // Pictures of an earlier run in the same folder, and a warning of gencase.
  const RunFolder& run = synthetic.folder();
  write_text(run.report() / "pictures" / "t0.250.svg", "<svg>of an earlier run</svg>");
  write_text(run.report() / "paraview" / "t0.100.png", "of an earlier run");
  fs::last_write_time(run.report() / "paraview" / "t0.100.png",
                      fs::last_write_time(run.snapshot_series()) - std::chrono::hours(1));
  WarningFile(run, "gencase").add("the wall is thin");
  ASSERT_EQ(setenv("THALWEG_GNUPLOT", "/nonexistent/gnuplot", 1), 0);
  testing::internal::CaptureStderr();
  const Exit status = postprocess({synthetic.folder().root, {}, true});
  const std::string said = testing::internal::GetCapturedStderr();
  ASSERT_EQ(unsetenv("THALWEG_GNUPLOT"), 0);
  EXPECT_EQ(status, Exit::done);
  EXPECT_THAT(said, HasSubstr("apt-get install gnuplot-nox"));
  EXPECT_TRUE(fs::exists(synthetic.folder().profiles() / "front.csv"));
  const std::string page = contents_of(run.report() / "index.html");
  EXPECT_THAT(page, HasSubstr("no picture: the remarks say why"));
  EXPECT_THAT(page, testing::Not(HasSubstr("of an earlier run")));
  EXPECT_THAT(page, HasSubstr("that are older than the snapshots are left out (1)"));
  EXPECT_THAT(page, HasSubstr("gencase: the wall is thin"));
}

TEST(Postprocess, OldProfilesOfOtherTimesDoNotSurvive) {
  const TemporaryFolder folder("old_profiles");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  write_text(synthetic.folder().profiles() / "t0.100.csv", "x [m],bed [m]\n0,1\n");
  EXPECT_EQ(postprocess({synthetic.folder().root, {}, false}), Exit::done);
  EXPECT_FALSE(fs::exists(synthetic.folder().profiles() / "t0.100.csv"));
}

TEST(Postprocess, WritesSurfacesAndSeriesOfAllSnapshots) {
  const TemporaryFolder folder("series");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  ASSERT_EQ(postprocess({run.root, {}, false}), Exit::done);
  for (const char* kind : {"free_surface", "bed", "motionless_bed"}) {
    EXPECT_EQ(read_series(run.surfaces() / (std::string(kind) + ".pvd")).size(), 11U) << kind;
    EXPECT_TRUE(fs::exists(run.surfaces() / (std::string(kind) + "_t0.250.vtp"))) << kind;
  }
  EXPECT_EQ(read_profile_set(run.profiles() / "all", "", SourceKind::run).profiles.size(), 11U);

  const CsvTable series = CsvTable::read(run.profiles() / "series.csv");
  ASSERT_EQ(series.rows(), 11U);
  // At 0.5 s the prescribed hole is 16 mm deep at x = 0.15 m less what the hump, 0.2 m further, adds there; by the
  // profile.
  double deepest = 0;
  double area = 0;
  for (double x = -0.5; x < 0.75; x += 0.0005) {
    const double fall = SyntheticRun::bed(x, 0) - SyntheticRun::bed(x, 0.5);
    deepest = std::max(deepest, fall);
    area += std::max(0.0, fall) * 0.0005;
  }
  EXPECT_NEAR(series.numbers("scour", "m").back(), deepest, 0.3 * SyntheticRun::spacing);
  // Within 0.03 m of its middle the hole is not shallower by more than the quarter of a spacing that is promised.
  EXPECT_NEAR(series.numbers("scour_x", "m").back(), 0.15, 0.03);
  EXPECT_NEAR(series.numbers("eroded", "m^2").back(), area, 0.1 * area);
  EXPECT_EQ(series.numbers("scour", "m").front(), 0);
  EXPECT_EQ(series.numbers("front", "m").back(),
            CsvTable::read(run.profiles() / "front.csv").numbers("front", "m").back());
}

TEST(Postprocess, GoesOnWhereAnEarlierPassWasBrokenOff) {
  const TemporaryFolder folder("repeated");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  ASSERT_EQ(postprocess({run.root, {}, false}), Exit::done);
  const std::string series = contents_of(run.profiles() / "series.csv");
  const fs::path kept = run.surfaces() / "bed_t0.300.vtp";
  const auto untouched = fs::last_write_time(kept);

  // As if killed after the seventh snapshot, in the middle of the eighth; and one result was deleted by hand.
  std::string progress = contents_of(run.profiles() / "progress.csv");
  progress.resize(progress.find("snapshots/s00007.vtp"));
  write_text(run.profiles() / "progress.csv", progress);
  fs::remove(run.profiles() / "all" / "t0.100.csv");
  fs::remove(run.profiles() / "series.csv");
  testing::internal::CaptureStdout();
  ASSERT_EQ(postprocess({run.root, {}, false}), Exit::done);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("11 snapshots (6 as an earlier pass left them)"));
  EXPECT_EQ(contents_of(run.profiles() / "series.csv"), series);
  EXPECT_EQ(fs::last_write_time(kept), untouched);
  EXPECT_TRUE(fs::exists(run.profiles() / "all" / "t0.100.csv"));

  // A snapshot that changed is measured again, a damaged one is named and its old results are not taken for its own.
  fs::resize_file(run.snapshots() / "s00004.vtp", 3000);
  testing::internal::CaptureStderr();
  EXPECT_EQ(postprocess({run.root, {}, false}), Exit::run_failed);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("s00004.vtp"));
  EXPECT_FALSE(fs::exists(run.surfaces() / "bed_t0.200.vtp"));
  EXPECT_EQ(CsvTable::read(run.profiles() / "series.csv").rows(), 10U);
}

}  // namespace
}  // namespace thalweg
