// The pages of a run: the report and the paper's figures.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/profile.hpp"
#include "postproc/postprocess.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using manufactured::contents_of;
using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using manufactured::write_text;
using testing::HasSubstr;

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

TEST(Postprocess, SaysAtTheTopThatARunFailedOrWasStopped) {
  const TemporaryFolder folder("shortfall");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  Case longer = read_case(run.resolved_case());
  longer.output.end = 0.8;
  write_case(run.resolved_case(), longer);
  PostprocessOptions options;
  options.folder = run.root;
  options.report = true;
  const auto head_of_page = [&] {
    EXPECT_EQ(postprocess(options), Exit::done);
    const std::string page = contents_of(run.report() / "index.html");
    return page.substr(0, page.find("</header>"));
  };
  EXPECT_THAT(head_of_page(), HasSubstr("The results end at t = 0.5 s of 0.8 s"));
  write_text(run.diverged(), "particles");
  EXPECT_THAT(head_of_page(), HasSubstr("This run failed after t = 0.5 s of 0.8 s"));
  longer.output.end = 0.5;
  write_case(run.resolved_case(), longer);
  EXPECT_THAT(head_of_page(), testing::Not(HasSubstr("class=\"warnings\"")));
}

TEST(Postprocess, ReportsWhereTheFirstSnapshotIsDamagedAndWhereThereIsOnlyOne) {
  const TemporaryFolder folder("few_snapshots");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const RunFolder& run = synthetic.folder();
  write_text(run.snapshots() / "s00000.vtp", "<VTKFile");
  PostprocessOptions options;
  options.folder = run.root;
  options.report = true;
  // Once measured anew, once from what the first pass has left.
  for (int pass = 0; pass < 2; ++pass) {
    EXPECT_EQ(postprocess(options), Exit::run_failed);
    EXPECT_THAT(contents_of(run.report() / "index.html"), HasSubstr("The bed before and after"));
  }
  write_series(run.snapshot_series(), {{0.25, "snapshots/s00005.vtp"}});
  EXPECT_EQ(postprocess(options), Exit::run_failed);  // the case asks for 0.5 s
  EXPECT_THAT(contents_of(run.report() / "index.html"), HasSubstr("nowhere: the bed has not fallen"));
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
  // The question and the answer stand first, then the course over time, the bed, the methods and the cost.
  std::size_t before = 0;
  for (const char* part : {"class=\"asked\"", "class=\"answer\"", "Scour depth and volume against time",
                           "<h2>The scene", "<h2>The bed before and after", "<h2>Depths of all methods",
                           "<h2>Which is which", "<h2>Profiles", "<h2>What it cost"}) {
    const std::size_t at = page.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GT(at, before) << part;
    before = at;
  }
  // The deepest of series.csv, and the scatter of equal runs as its band.
  const std::vector<double> scour = CsvTable::read(run.profiles() / "series.csv").numbers("scour", "m");
  const double deepest = *std::max_element(scour.begin(), scour.end());
  EXPECT_THAT(page, HasSubstr(fmt::format("<div class=\"v\">{:.1f} <span>mm</span>", 1e3 * deepest)));
  EXPECT_THAT(page, HasSubstr("<dd>± 3.0\u00a0mm: equal runs scatter by 3.0\u00a0mm"));
  EXPECT_THAT(page, HasSubstr("The snapshots of this run carry none"));
  EXPECT_THAT(page, HasSubstr("host not recorded, date not recorded"));
  // A repeated pass reads what the first one measured, with the same result.
  const std::string bed_change = contents_of(run.report() / "data" / "bed_change.csv");
  ASSERT_EQ(postprocess(options), Exit::done);
  EXPECT_EQ(contents_of(run.report() / "errors.csv"), errors);
  EXPECT_EQ(contents_of(run.report() / "data" / "bed_change.csv"), bed_change);
  EXPECT_EQ(contents_of(run.report() / "index.html"), page);
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

}  // namespace
}  // namespace thalweg
