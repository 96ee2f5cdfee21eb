#include "postproc/postprocess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/profile.hpp"
#include "postproc/movie.hpp"
#include "postproc/profile_set.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using manufactured::write_text;
using testing::HasSubstr;

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// A mesh model's profiles: the prescribed surfaces shifted by `offset` [m], on columns of `cell` [m], no moving bed.
void write_mesh_model(const fs::path& folder, double cell, double offset) {
  for (const double t : {0.25, 0.5}) {
    Profile profile;
    for (double x = -0.5 + cell / 2; x < 0.75; x += cell) {
      profile.x.push_back(x);
      profile.free_surface.push_back(SyntheticRun::surface(x, t) + offset);
      profile.bed.push_back(SyntheticRun::bed(x, t) + offset);
    }
    write_profile(folder / "profiles" / profile_file_name(t), profile, {"synthetic mesh model"});
  }
  write_text(folder / "summary.csv", fmt::format("quantity,value,unit\ncell_size,{:g},m\ncells,5250,-\nsteps,511,-\n"
                                                 "wall_seconds,36.1,s\n",
                                                 cell));
}

double rms_misfit(const std::vector<double>& x, const std::vector<double>& z, double (*truth)(double, double),
                  double t) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double error = z[i] - truth(x[i], t);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(x.size()));
}

TEST(Postprocess, WritesProfilesFrontComparisonAndReport) {
  const TemporaryFolder folder("report");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  write_mesh_model(run.foam(), 0.01, 0.002);
  write_mesh_model(run.foam() / "coarse", 0.02, 0.004);
  write_text(
      synthetic.case_folder() / "reference" / "t0.250.csv",
      "# digitised\nx [m],bed [m],free_surface [m]\n-0.1,0.0595,0.118\n0,0.0567,0.107\n0.1,0.0506,0.097\n0.3,,0.084\n");
  write_text(synthetic.case_folder() / "repeatability.csv",
             "# two runs with different solver tolerance\ncurve,time [s],rms [m]\nbed,0.25,0.0005\nbed,0.5,0.003\n");
  PostprocessOptions options;
  options.folder = run.root;
  options.report = true;
  ASSERT_EQ(postprocess(options), Exit::done);

  for (const double t : {0.25, 0.5}) {
    const Profile profile = read_profile(run.profiles() / profile_file_name(t));
    EXPECT_LT(rms_misfit(profile.x, profile.bed, SyntheticRun::bed, t), 0.25 * SyntheticRun::spacing) << t;
    EXPECT_EQ(profile.x.size(), 251U);  // -0.5 m to 0.75 m by 5 mm
  }
  const std::string front = contents_of(run.profiles() / "front.csv");
  EXPECT_THAT(front, HasSubstr("time [s],front [m]\n0,"));
  std::smatch last;
  ASSERT_TRUE(std::regex_search(front, last, std::regex("\n0\\.5,([0-9.]+)\n$")));
  EXPECT_NEAR(std::stod(last[1]), SyntheticRun::front_speed * 0.5, 2 * SyntheticRun::spacing);

  const std::string errors = contents_of(run.report() / "errors.csv");
  EXPECT_THAT(errors, HasSubstr("\nmeasured,Thalweg SPH,,bed,0.25,3,"));
  EXPECT_THAT(errors, HasSubstr("\nOpenFOAM 10 mm,Thalweg SPH,,free_surface,0.5,"));
  EXPECT_THAT(errors, HasSubstr("OpenFOAM 20 mm has no moving_bed, not compared"));

  for (const char* picture :
       {"t0.250.svg", "t0.500.png", "front.svg", "energies.svg", "particles.png", "space_time.png", "t0.250.gp"}) {
    EXPECT_GT(fs::file_size(run.report() / "pictures" / picture), 500U) << picture;
  }
  const std::string page = contents_of(run.report() / "index.html");
  EXPECT_THAT(page, HasSubstr("Prescribed dam break over an erodible bed"));
  EXPECT_THAT(page, HasSubstr("<svg role=\"img\" aria-label=\"Profiles at t = 0.25 s\""));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(page, HasSubstr("friction_angle"));
  EXPECT_THAT(page, HasSubstr("scatter of equal runs"));
  EXPECT_THAT(page, HasSubstr("cell size"));
  EXPECT_THAT(page, HasSubstr("mesh (finite volumes)"));
  EXPECT_THAT(page, HasSubstr("<figure id=\"figure_t0_250\">"));
  // Self-contained: nothing is fetched, links go to files beside the page.
  EXPECT_FALSE(
      std::regex_search(page, std::regex("<(link|iframe)|<script[^>]* src|src=\"(?!data:)|url\\((?!#)|@import")));
}

// A finished run of a series: its case at another spacing, and the front it had.
void write_series_run(const fs::path& folder, const Case& base, double spacing, double front) {
  Case resolved = base;
  resolved.info.name = "series";
  resolved.numerics.spacing = spacing;
  write_case(RunFolder{folder}.resolved_case(), resolved);
  write_text(RunFolder{folder}.profiles() / "front.csv",
             fmt::format("time [s],front [m]\n0,0\n0.25,{:g}\n0.5,{:g}\n", front, 2 * front));
}

TEST(PaperFigures, HoldTheNumbersOfTheRunAndEmptySlotsForWhatIsMissing) {
  const TemporaryFolder folder("paper");
  const SyntheticRun synthetic(folder.path() / "run");
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  write_mesh_model(run.foam(), 0.01, 0.002);
  PostprocessOptions options;
  options.folder = run.root;
  options.paper_figures = true;
  ASSERT_EQ(postprocess(options), Exit::done);
  const fs::path paper = run.report() / "paper";
  std::string page = contents_of(paper / "index.html");
  EXPECT_THAT(page, HasSubstr("empty slot: runs at two spacings or more"));
  EXPECT_THAT(page, HasSubstr("empty slot: measured profiles"));
  EXPECT_FALSE(fs::exists(paper / "data" / "fig06_front.csv"));

  const Case base = read_case(run.resolved_case());
  for (const double spacing : {0.016, 0.008}) {
    options.series.push_back(folder.path() / fmt::format("series_{:g}", spacing));
    write_series_run(options.series.back(), base, spacing, 0.3 + spacing);
  }
  ASSERT_EQ(postprocess(options), Exit::done);
  EXPECT_THAT(contents_of(paper / "data" / "fig06_front.csv"),
              HasSubstr("\n8,0.25,0.308\n8,0.5,0.616\n16,0.25,0.316\n16,0.5,0.632\n"));

  // The prescribed bed is deepest at x = 0.15 m, where the hump has gone: 16 mm but for the hump's tail, and the mesh
  // model lies 2 mm higher; a quarter of the spacing is what the extraction may be off by.
  const CsvTable scour = CsvTable::read(paper / "data" / "fig13_scour.csv");
  const std::vector<double> depths = scour.numbers("scour", "m");
  double truth = 0;
  for (double x = 0; x < 0.3; x += 0.001) truth = std::max(truth, SyntheticRun::bed_level - SyntheticRun::bed(x, 0.5));
  const std::vector<std::string> sources = scour.texts("source");
  const auto last_of = [&](const char* source) {
    return depths[static_cast<std::size_t>(std::find(sources.rbegin(), sources.rend(), source).base() -
                                           sources.begin()) -
                  1];
  };
  EXPECT_EQ(std::count(sources.begin(), sources.end(), "Thalweg SPH"), 11) << "one for each snapshot";
  EXPECT_NEAR(last_of("Thalweg SPH"), truth, 0.25 * SyntheticRun::spacing);
  EXPECT_NEAR(last_of("OpenFOAM 10 mm"), truth - 0.002, 0.25 * SyntheticRun::spacing);

  const CsvTable errors = CsvTable::read(paper / "data" / "fig12_local_errors.csv");
  const std::vector<std::string> sections = errors.texts("section");
  const std::vector<double> bed = errors.numbers("bed_error", "m");
  ASSERT_EQ(sections, (std::vector<std::string>{"S1", "S2", "S3", "S1", "S2", "S3"}));
  for (const double error : bed) EXPECT_NEAR(error, -0.002, 0.3 * SyntheticRun::spacing);
  page = contents_of(paper / "index.html");
  EXPECT_FALSE(std::regex_search(page, std::regex("<(link|iframe|script)|src=\"(?!data:)")));
}

TEST(Movie, HasAFrameOfEverySnapshotThatShowsWaterAndSediment) {
  const TemporaryFolder folder("movie");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  fs::resize_file(synthetic.folder().snapshots() / "s00003.vtp", 5000);
  const Movie movie = make_movie(synthetic.folder(), read_case(synthetic.folder().resolved_case()));
  if (movie.frames == 0) GTEST_SKIP() << movie.warnings.front();  // neither a display nor Xvfb
  EXPECT_EQ(movie.frames, 10U);                                   // of eleven, one of which is damaged
  EXPECT_THAT(movie.warnings, testing::Contains(HasSubstr("skipped: ")));
  for (std::size_t n = 0; n < movie.frames; ++n) {
    EXPECT_GT(fs::file_size(synthetic.folder().root / "movie" / fmt::format("f{:05}.png", n)), 10'000U) << n;
  }
  if (movie.film.empty()) {
    EXPECT_THAT(movie.warnings, testing::Contains(HasSubstr("apt-get install ffmpeg")));
  } else {
    EXPECT_GT(fs::file_size(movie.film), 10'000U);
  }
}

TEST(Movie, WithoutAnyDisplaySaysWhatToInstall) {
  const TemporaryFolder folder("no_display");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const char* path = std::getenv("PATH");
  const std::string programs = path != nullptr ? path : "";
  const char* display = std::getenv("DISPLAY");
  const std::string screen = display != nullptr ? display : "";
  ASSERT_EQ(unsetenv("DISPLAY"), 0);
  ASSERT_EQ(setenv("PATH", "/nonexistent", 1), 0);
  const Movie movie = make_movie(synthetic.folder(), read_case(synthetic.folder().resolved_case()));
  ASSERT_EQ(setenv("PATH", programs.c_str(), 1), 0);
  if (display != nullptr) {
    ASSERT_EQ(setenv("DISPLAY", screen.c_str(), 1), 0);
  }
  EXPECT_EQ(movie.frames, 0U);
  ASSERT_EQ(movie.warnings.size(), 1U);
  EXPECT_THAT(movie.warnings.front(), HasSubstr("apt-get install xvfb"));
}

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
  ASSERT_EQ(setenv("THALWEG_GNUPLOT", "/nonexistent/gnuplot", 1), 0);
  testing::internal::CaptureStderr();
  const Exit status = postprocess({synthetic.folder().root, {}, true});
  const std::string said = testing::internal::GetCapturedStderr();
  ASSERT_EQ(unsetenv("THALWEG_GNUPLOT"), 0);
  EXPECT_EQ(status, Exit::run_failed);
  EXPECT_THAT(said, HasSubstr("apt-get install gnuplot-nox"));
  EXPECT_TRUE(fs::exists(synthetic.folder().profiles() / "front.csv"));
  EXPECT_THAT(contents_of(synthetic.folder().report() / "index.html"),
              HasSubstr("no picture: gnuplot is not installed"));
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
