#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "postproc/constants.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/measure_settings.hpp"
#include "postproc/report_sources.hpp"
#include "postproc/run_records.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::contents_of;
using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using manufactured::write_text;
using testing::HasSubstr;

TEST(Constants, ListEveryKeyWithItsUnitAndSayWhatTheCaseGave) {
  const TemporaryFolder folder("constants");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const Case resolved = read_case(synthetic.folder().resolved_case());
  const std::vector<ConstantTable> tables = list_constants(resolved);
  const auto find = [&](const std::string& table, const std::string& key) {
    for (const ConstantTable& candidate : tables) {
      for (const Constant& row : candidate.rows) {
        if (candidate.name == table && row.key == key) return row;
      }
    }
    ADD_FAILURE() << table << "." << key << " is not listed";
    return Constant{};
  };
  EXPECT_EQ(find("materials.pvc", "friction_angle").value, "38 deg");
  EXPECT_FALSE(find("materials.pvc", "friction_angle").is_default);
  EXPECT_TRUE(find("numerics", "cfl").is_default);
  EXPECT_EQ(find("numerics", "spacing").value, "5 mm");
  EXPECT_EQ(find("model", "sediment").value, "viscoplastic");
  EXPECT_THAT(find("shape", "tank").value, HasSubstr("water"));

  const std::vector<Switch> switches = list_switches(resolved);
  const auto is_on = [&](const std::string& name) {
    const auto found = std::find_if(switches.begin(), switches.end(), [&](const Switch& s) { return s.name == name; });
    EXPECT_NE(found, switches.end()) << name;
    return found != switches.end() && found->on;
  };
  EXPECT_TRUE(is_on("sediment = viscoplastic"));
  EXPECT_TRUE(is_on("density diffusion"));
  EXPECT_FALSE(is_on("cohesion of pvc"));
  EXPECT_FALSE(is_on("periodic directions"));

  // A twentieth of sqrt(9.81 m/s^2 * 3.5 mm) = 0.1853 m/s.
  EXPECT_NEAR(rest_speed_of(resolved), 0.05 * 0.1853, 1e-5);
}

TEST(RunRecords, CountWhatLimitedTheStepAndReadTheSummary) {
  const TemporaryFolder folder("records");
  write_text(folder.path() / "history.csv",
             "time [s],dt [s],dt_limiter\n0,1e-4,acoustic\n1,2e-4,force\n2,1e-4,acoustic\n3,1e-4,acoustic\n");
  const History history = read_history(folder.path() / "history.csv");
  EXPECT_EQ(history.rows, 4U);
  ASSERT_EQ(history.limiters.size(), 2U);
  EXPECT_EQ(history.limiters[0].limiter, "acoustic");
  EXPECT_DOUBLE_EQ(history.limiters[0].share, 0.75);
  EXPECT_TRUE(history.water_mass.empty());
  EXPECT_EQ(read_history(folder.path() / "none.csv").rows, 0U);

  write_text(folder.path() / "summary.csv", "quantity,value,unit\nsteps,12,-\nbackend,openmp,-\n");
  const std::vector<Quantity> summary = read_quantities(folder.path() / "summary.csv");
  EXPECT_EQ(number_of(summary, "steps"), 12);
  EXPECT_EQ(text_of(summary, "backend"), "openmp");
  EXPECT_FALSE(number_of(summary, "backend"));
  EXPECT_FALSE(number_of(summary, "wall_seconds"));
}

TEST(Figures, FrameHoldsAllCurvesAndFolderNamesArePlain) {
  Profile profile;
  profile.x = {-1, 0, 1};
  profile.free_surface = {0.2, 0.1, Profile::missing};
  const ProfileSet set{"a", SourceKind::run, "a", {{0.25, "a/t0.250.csv", profile}}};
  const PictureFrame all = frame_around({set}, 0, 0);
  EXPECT_DOUBLE_EQ(all.x_from, -1);
  EXPECT_DOUBLE_EQ(all.x_to, 0);
  EXPECT_DOUBLE_EQ(all.z_from, 0);
  EXPECT_GT(all.z_to, 0.2);
  EXPECT_DOUBLE_EQ(frame_around({set}, -0.5, 0.7).x_to, 0.7);
  EXPECT_EQ(folder_name_of("OpenFOAM 10 mm"), "openfoam_10_mm");
  EXPECT_EQ(folder_name_of("../.."), "source");
}

TEST(ScriptTemplate, NeedsAValueForEachPlaceholderAndAPlaceholderForEachValue) {
  EXPECT_EQ(fill_template("plot {{data}} using {{x}}:{{x}}\n", {{"data", "'a.csv'"}, {"x", "{{1}}"}}),
            "plot 'a.csv' using {{1}}:{{1}}\n");
  EXPECT_THROW(fill_template("plot {{data}}", {}), std::logic_error);
  EXPECT_THROW(fill_template("plot {{data", {{"data", "x"}}), std::logic_error);
  EXPECT_THROW(fill_template("plot x", {{"data", "x"}}), std::logic_error);
}

TEST(Gnuplot, AFailingScriptIsReportedWithItsMessage) {
  const TemporaryFolder folder("gnuplot");
  write_text(folder.path() / "wrong.gp", "plot 'there is no such file.csv'\n");
  try {
    if (run_gnuplot(folder.path() / "wrong.gp") == GnuplotResult::not_installed) GTEST_SKIP() << "gnuplot is not here";
    ADD_FAILURE() << "no RunError";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("wrong.gp: gnuplot failed: "));
  }
  EXPECT_EQ(gnuplot_string("it's\nso"), "'it''s so'");
}

/// A stand-in for gnuplot: a shell script of these lines.
void install_gnuplot(const std::filesystem::path& program, const std::string& lines) {
  write_text(program, "#!/bin/sh\n" + lines);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  ASSERT_EQ(setenv("THALWEG_GNUPLOT", program.c_str(), 1), 0);
}

TEST(Gnuplot, IsEndedWhenItHangsAndLeavesTheOldPicture) {
  const TemporaryFolder folder("gnuplot_hangs");
  install_gnuplot(folder.path() / "hang", "trap '' TERM\necho half > a.png\nexec sleep 60\n");
  write_text(folder.path() / "p" / "a.gp", "set output 'a.svg'\nset output 'b.png'\n");
  write_text(folder.path() / "p" / "b.png", "old");
  try {
    run_gnuplot(folder.path() / "p" / "a.gp", std::chrono::seconds(1));
    ADD_FAILURE() << "no RunError";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.gp: "));
    EXPECT_THAT(error.what(), HasSubstr("did not end within 1 s and was ended; "));
  }
  unsetenv("THALWEG_GNUPLOT");
  EXPECT_EQ(contents_of(folder.path() / "p" / "b.png"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "p" / "a.svg"));
}

TEST(Gnuplot, AScriptThatFailsCostsItsOwnPictureAlone) {
  const TemporaryFolder folder("gnuplot_fails");
  install_gnuplot(folder.path() / "draw", "grep -q bad \"$2\" && { echo a bad script; exit 1; }\nexit 0\n");
  std::vector<std::filesystem::path> scripts;
  for (const char* name : {"good", "bad", "better"}) {
    scripts.push_back(folder.path() / "p" / (std::string(name) + ".gp"));
    write_text(scripts.back(), std::string(name) + "\n");
  }
  std::vector<std::string> warnings;
  EXPECT_FALSE(draw_pictures(scripts, warnings));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], testing::StartsWith("1 of 3 pictures are missing: "));
  EXPECT_THAT(warnings[0], HasSubstr("bad.gp: "));
  EXPECT_THAT(warnings[0], HasSubstr("a bad script"));
  scripts.erase(scripts.begin() + 1);
  EXPECT_TRUE(draw_pictures(scripts, warnings));
  EXPECT_EQ(warnings.size(), 1U);
  unsetenv("THALWEG_GNUPLOT");
}

TEST(Gnuplot, PutsPicturesInPlaceWhole) {
  const TemporaryFolder folder("gnuplot_whole");
  // It draws into the names that the script gives, none of which is a picture's own.
  install_gnuplot(folder.path() / "draw",
                  "sed -n \"s/^set output '\\(.*\\)'/\\1/p\" \"$2\" | while read name; do\n"
                  "  case $name in .a.*.part.*) ;; *) exit 1 ;; esac\n  echo drawn > \"$name\"\ndone\n");
  write_text(folder.path() / "p" / "a.gp", "set output 'a.svg'\nplot\nset output 'a.png'\nreplot\n");
  EXPECT_EQ(run_gnuplot(folder.path() / "p" / "a.gp"), GnuplotResult::drawn);
  unsetenv("THALWEG_GNUPLOT");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "p"))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("a.gp", "a.svg", "a.png"));
  EXPECT_EQ(contents_of(folder.path() / "p" / "a.png"), "drawn\n");
}

TEST(Measurements, MayLieAlongLinesAlone) {
  const TemporaryFolder folder("measured_lines");
  std::filesystem::create_directories(folder.path() / "reference/s1");
  write_text(folder.path() / "reference/s1/t20.000.csv", "x [m],bed [m]\n0.1,0.03\n0.2,0.05\n");
  ReportInput input;
  input.resolved.folder = folder.path();
  add_measurements(input);
  EXPECT_TRUE(input.line_sources.empty());
  EXPECT_EQ(input.reference_notes.size(), 1U);

  input.resolved.lines = {{"s1", {0, 0.2}, {1, 0.2}}, {"s2", {0, 0.7}, {1, 0.7}}};
  add_measurements(input);
  EXPECT_TRUE(input.sets.empty());  // nothing to draw along x
  ASSERT_EQ(input.line_sources.size(), 1U);
  const std::optional<ProfileSet> along = read_line_set(input.line_sources.front(), "s1");
  ASSERT_TRUE(along && along->at(20) != nullptr);
  EXPECT_EQ(along->at(20)->profile.bed.at(1), 0.05);
  EXPECT_FALSE(read_line_set(input.line_sources.front(), "s2"));
}

}  // namespace
}  // namespace thalweg
