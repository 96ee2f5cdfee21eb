#include "postproc/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "postproc/bed_change.hpp"
#include "postproc/html.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::TemporaryFolder;
using manufactured::write_text;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double gap = Profile::missing;

ProfileSet set_of(const std::string& label, SourceKind kind, const std::vector<std::pair<double, Profile>>& profiles) {
  ProfileSet set{label, kind, label, {}};
  for (const auto& [time, profile] : profiles) set.profiles.push_back({time, profile_file_name(time), profile});
  return set;
}

Profile bed_profile(std::vector<double> x, std::vector<double> bed) {
  Profile profile;
  profile.x = std::move(x);
  profile.bed = std::move(bed);
  return profile;
}

// Errors at x = 1, 2, 3 are 0.1, -0.2, 0.4 by hand: the compared line z = x / 10 halfway between its points.
TEST(Compare, GivesTheNormsWorkedByHand) {
  const ProfileSet measured =
      set_of("measured", SourceKind::measured, {{0.25, bed_profile({1, 2, 3}, {0.1 - 0.1, 0.2 + 0.2, 0.3 - 0.4})}});
  const ProfileSet run =
      set_of("run", SourceKind::run, {{0.25, bed_profile({0.5, 1.5, 2.5, 3.5}, {0.05, 0.15, 0.25, 0.35})}});
  const Comparison result = compare(measured, run, {});
  ASSERT_EQ(result.errors.size(), 1U);
  const CurveError& error = result.errors.front();
  EXPECT_EQ(error.curve, "bed");
  EXPECT_EQ(error.points, 3U);
  EXPECT_NEAR(error.rmse, std::sqrt((0.01 + 0.04 + 0.16) / 3), 1e-12);
  EXPECT_NEAR(error.bias, (0.1 - 0.2 + 0.4) / 3, 1e-12);
  EXPECT_NEAR(error.largest_error, 0.4, 1e-12);
  EXPECT_DOUBLE_EQ(error.largest_error_at, 3);
  EXPECT_NEAR(error.normalised_rmse, error.rmse / 0.5, 1e-12);  // the reference runs from -0.1 to 0.4
  EXPECT_DOUBLE_EQ(error.from, 1);
  EXPECT_DOUBLE_EQ(error.to, 3);
}

TEST(Compare, DoesNotReachBeyondEndsAcrossGapsOrOutsideTheRange) {
  const ProfileSet reference =
      set_of("a", SourceKind::mesh, {{1, bed_profile({0, 1, 2, 3, 4, 5}, {0, 0, 0, gap, 0, 0})}});
  const ProfileSet compared =
      set_of("b", SourceKind::run, {{1, bed_profile({0.5, 1.5, 2.5, 4, 4.5}, {1, gap, 1, 1, 1})}});
  // x = 0 and 5 lie beyond the ends, 1 and 2 beside the gap of b, 3 is missing in a: only 4 is left.
  const Comparison result = compare(reference, compared, {});
  ASSERT_EQ(result.errors.size(), 1U);
  EXPECT_EQ(result.errors.front().points, 1U);
  EXPECT_DOUBLE_EQ(result.errors.front().from, 4);
  EXPECT_TRUE(std::isnan(result.errors.front().normalised_rmse));  // one level point has no range
  const Comparison outside = compare(reference, compared, {0, 3.5, 0});
  EXPECT_THAT(outside.errors, IsEmpty());
  EXPECT_THAT(outside.remarks, Contains(HasSubstr("no common points of bed at 1 s")));
}

TEST(Compare, NamesColumnsAndTimesOnlyOneSourceHas) {
  Profile full = bed_profile({0, 1}, {0, 0});
  full.free_surface = {1, 1};
  const ProfileSet run = set_of("run", SourceKind::run, {{0.25, full}, {0.5, full}});
  const ProfileSet measured = set_of("measured", SourceKind::measured,
                                     {{0.2503, bed_profile({0, 1}, {0, 0.1})}, {0.75, bed_profile({0, 1}, {0, 0})}});
  const Comparison result = compare_all({run, measured}, {});
  ASSERT_EQ(result.errors.size(), 1U);  // 0.2503 s is 0.25 s
  EXPECT_EQ(result.errors.front().reference, "measured");
  EXPECT_EQ(result.errors.front().compared, "run");
  EXPECT_THAT(result.remarks, Contains(HasSubstr("measured has no free_surface, not compared")));
  EXPECT_THAT(result.remarks, Contains(HasSubstr("only run has a profile at 0.5 s")));
  EXPECT_THAT(result.remarks, Contains(HasSubstr("only measured has a profile at 0.75 s")));
  EXPECT_THAT(result.remarks, testing::Not(Contains(HasSubstr("moving_bed"))));  // neither has it: nothing is lacking
  EXPECT_THAT(table_of(result), HasSubstr("run against measured"));
}

// The bed falls by 2, 2, 2 where it was 0; the model says 1, 2, 3: 1 - (1 + 0 + 1)/(4 + 4 + 4).
TEST(Compare, ScoresTheBedsChangeAgainstOneThatStays) {
  ProfileSet measured = set_of("measured", SourceKind::measured, {{1, bed_profile({1, 2, 3}, {-2, -2, -2})}});
  ProfileSet run = set_of("run", SourceKind::run, {{1, bed_profile({1, 2, 3}, {-1, -2, -3})}});
  const Comparison unknown = compare(measured, run, {});
  EXPECT_TRUE(std::isnan(unknown.errors.front().brier_skill));
  EXPECT_THAT(unknown.remarks, Contains(HasSubstr("no Brier skill score")));

  run.initial = TimedProfile{0, {}, bed_profile({0, 4}, {0, 0})};
  const Comparison result = compare(measured, run, {});
  EXPECT_NEAR(result.errors.front().brier_skill, 1 - 2.0 / 12, 1e-12);
  EXPECT_THAT(result.remarks, Contains(HasSubstr("measured has no bed at 0 s; its change counts from that of run")));
  ASSERT_EQ(result.scalars.size(), 3U);  // neither has a free surface, hence no front
  EXPECT_EQ(result.scalars[0].quantity, "scour");
  EXPECT_DOUBLE_EQ(result.scalars[0].reference_value, 2);
  EXPECT_DOUBLE_EQ(result.scalars[0].compared_value, 3);
  EXPECT_DOUBLE_EQ(result.scalars[1].compared_value, 3);  // its place

  measured.initial = TimedProfile{0, {}, bed_profile({1, 3}, {-2, -2})};  // nothing changed: there is no score
  EXPECT_TRUE(std::isnan(compare(measured, run, {}).errors.front().brier_skill));
}

// Three runs at 0, 1 and 3: pairs differ by 1, 3 and 2.
TEST(Compare, PutsTheScatterOfRepeatedRunsBesideTheErrors) {
  std::vector<ProfileSet> repeated;
  for (const double level : {0.0, 1.0, 3.0}) {
    repeated.push_back(set_of("run", SourceKind::run, {{1, bed_profile({1, 2}, {level, level})}}));
  }
  const std::vector<Scatter> scatter = scatter_of(repeated);
  ASSERT_EQ(scatter.size(), 1U);
  EXPECT_NEAR(scatter[0].rms, std::sqrt((1 + 9 + 4) / 3.0), 1e-12);
  const ProfileSet measured = set_of("measured", SourceKind::measured, {{1, bed_profile({1, 2}, {0, 0})}});
  Comparison result = compare_all({repeated.front(), measured}, {});
  add_scatter(result, "run", scatter);
  EXPECT_EQ(result.errors.front().scatter, scatter[0].rms);
  EXPECT_EQ(result.errors.front().scatter_runs, 3);
  EXPECT_THAT(scatter_of({measured}), IsEmpty());
}

TEST(Compare, TakesFrontsFromTheProfilesAndNamesAMissingOneByAnEmptyCell) {
  const TemporaryFolder folder("fronts");
  Profile pool;
  pool.x = {0, 1, 2, 3};
  pool.bed = {0, 0, 0, 0};
  pool.free_surface = {1, 1, 0, 0};  // falls below a depth of 0.5 half-way between 1 and 2
  Profile open_end = pool;
  open_end.x = {0, 1};
  open_end.bed.resize(2);
  open_end.free_surface.resize(2);  // a measurement that ends while it is wet
  const ProfileSet run = set_of("run", SourceKind::run, {{1, pool}});
  const ProfileSet measured = set_of("measured", SourceKind::measured, {{1, open_end}});
  ComparedRange range;
  range.least_depth = 0.5;
  const Comparison result = compare(measured, run, range);
  ASSERT_EQ(result.scalars.size(), 1U);
  EXPECT_TRUE(std::isnan(result.scalars[0].reference_value));
  EXPECT_DOUBLE_EQ(result.scalars[0].compared_value, 1.5);
  write_errors(folder.path(), result);
  const CsvTable scalars = CsvTable::read(folder.path() / "scalars.csv");
  EXPECT_EQ(scalars.texts("reference_value").front(), "");
  EXPECT_EQ(scalars.texts("error").front(), "");
  EXPECT_EQ(scalars.texts("compared_value").front(), "1.5");
}

TEST(ReadNamedSets, ReadsFilesFoldersAndRunsUnderTheirLabels) {
  const TemporaryFolder folder("named_sets");
  const std::string contents = "x [m],bed [m]\n0,0.1\n1,0.1\n";
  write_text(folder.path() / "lab" / "t0.250.csv", contents);
  write_text(folder.path() / "lab" / "t0.500.csv", contents);
  write_text(folder.path() / "other_run" / "profiles" / "t1.000.csv", contents);
  write_text(folder.path() / "lab" / "bed.csv", contents);
  const std::string lab = (folder.path() / "lab").string();

  const auto files = read_named_sets({lab + "/t0.500.csv", lab + "/t0.250.csv"});
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].label, "lab");
  ASSERT_EQ(files[0].profiles.size(), 2U);
  EXPECT_DOUBLE_EQ(files[0].profiles[0].time, 0.25);

  const auto named = read_named_sets({"Paper=" + lab, (folder.path() / "other_run").string()});
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0].label, "Paper");
  EXPECT_EQ(named[1].label, "other_run");
  ASSERT_NE(named[1].at(1.0003), nullptr);
  EXPECT_EQ(named[1].at(1.001), nullptr);

  EXPECT_THROW(read_named_sets({lab + "/bed.csv"}), InputError);          // no time in the name
  EXPECT_THROW(read_named_sets({lab + "/t0.750.csv"}), InputError);       // not there
  EXPECT_THROW(read_named_sets({lab, lab + "/t0.250.csv"}), InputError);  // one time twice under one label
  EXPECT_THROW(read_named_sets({folder.path().string()}), InputError);    // no profile in it
  EXPECT_THROW(read_named_sets({"/dev/zero"}), InputError);               // neither file nor folder
  EXPECT_THROW(read_named_sets({std::string(5000, 'L') + "=" + lab}), InputError);
  EXPECT_THROW(read_named_sets({std::string(5000, 'L')}), InputError);
}

TEST(BedChange, CountsWhereSedimentLies) {
  Profile before = bed_profile({0, 1, 2, 3}, {0.1, 0.1, 0.1, gap});
  Profile after = bed_profile({1, 2, 3}, {0.07, 0.12, 0.1});
  const std::vector<double> rise = rise_of_bed(before, after);
  EXPECT_NEAR(rise[0], -0.03, 1e-12);
  EXPECT_NEAR(rise[1], 0.02, 1e-12);
  EXPECT_TRUE(std::isnan(rise[2]));

  // From the left: a bare floor, a floor that sand comes to, sand that goes, a deck in its place, a dry floor.
  before = bed_profile({0, 1, 2, 3, 4}, {0, 0, 0.1, 0.1, gap});
  before.free_surface = {0.2, 0.2, 0.2, 0.2, gap};
  before.floor = {0, 0, 0, 0, 0};
  after = bed_profile({0, 1, 2, 3, 4}, {0, 0.05, 0, 5, 0.02});
  after.free_surface = {0.2, 0.2, 0.2, 5.1, 0.2};
  after.floor = {0, 0, 0, 5, 0};
  const std::vector<double> counted = rise_of_bed(before, after);
  EXPECT_TRUE(std::isnan(counted[0]));
  EXPECT_NEAR(counted[1], 0.05, 1e-12);
  EXPECT_NEAR(counted[2], -0.1, 1e-12);
  EXPECT_TRUE(std::isnan(counted[3]));
  EXPECT_NEAR(counted[4], 0.02, 1e-12);
}

TEST(Html, EscapesGroupsAndInlines) {
  EXPECT_EQ(html::escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
  EXPECT_EQ(html::grouped(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(html::grouped(-123), "-123");
  EXPECT_EQ(html::grouped(999), "999");
  EXPECT_EQ(html::typeset("0 m/s^2, -9.81 m/s^2"), "0 m/s<sup>2</sup>, \u22129.81 m/s<sup>2</sup>");
  EXPECT_EQ(html::typeset("-1.5e-06"), "\u22121.5\u202f×\u202f10<sup>\u22126</sup>");
  EXPECT_EQ(html::typeset("2-D, 262.5 us"), "2-D, 262.5 µs");
  const TemporaryFolder folder("html");
  write_text(folder.path() / "a.svg",
             "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 1 1\"><title>Gnuplot</title><g id='p'/><use "
             "xlink:href='#p'/></svg>");
  const std::string svg = html::inline_svg(folder.path() / "a.svg", "x", "A \"title\"");
  EXPECT_EQ(svg,
            "<svg role=\"img\" aria-label=\"A &quot;title&quot;\" viewBox=\"0 0 1 1\"><g id='x_p'/><use "
            "xlink:href='#x_p'/></svg>");
  for (const auto& [bytes, text] : {std::pair{"M", "TQ=="}, std::pair{"Ma", "TWE="}, std::pair{"Man", "TWFu"}}) {
    write_text(folder.path() / "a.png", bytes);  // the examples of RFC 4648
    EXPECT_THAT(html::inline_png(folder.path() / "a.png", ""), HasSubstr(std::string("base64,") + text + "\""));
  }
  EXPECT_EQ(html::inline_svg(folder.path() / "none.svg", "x", ""), "");
}

}  // namespace
}  // namespace thalweg
