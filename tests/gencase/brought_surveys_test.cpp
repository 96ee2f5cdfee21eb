#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/error.hpp"
#include "gencase/places.hpp"
#include "gencase/survey_reader.hpp"
#include "tests/gencase/scene.hpp"

// Surveys as instruments and spreadsheets write them.
namespace thalweg::gencase::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class BroughtSurvey : public testing::Test {
 protected:
  BroughtSurvey() : folder_(fs::temp_directory_path() / ("brought_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~BroughtSurvey() override { fs::remove_all(folder_); }
  fs::path written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string refused(const std::string& name, const std::string& text) const {
    try {
      read_survey(written(name, text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "accepted";
  }
  /// A tank of 4 m x 3 m with the survey as its floor.
  Case tank(const std::string& name, const std::string& text) const {
    Case scene = empty_scene(3, 0.1);
    scene.domain.from = Vec3(-1, -1, -1);
    scene.domain.to = Vec3(5, 4, 2);
    add_tank(scene, Vec3(0, 0, 0), Vec3(4, 3, 1));
    Shape& bed = add_box(scene, "bed", ShapeRole::wall, Vec3::Zero(), Vec3::Zero());
    bed.kind = ShapeKind::bathymetry;
    bed.file = written(name, text).filename();
    bed.base = -0.4;
    scene.folder = folder_;
    Shape& pool = add_box(scene, "pool", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
    pool.kind = ShapeKind::level;
    pool.level = 0.6;
    return scene;
  }
  static std::vector<std::string> warnings_of(const Case& scene) {
    std::vector<std::string> lines;
    GenerateOptions options;
    options.notes.warn = [&](const std::string& line) { lines.push_back(line); };
    generate(scene, options);
    return lines;
  }
  fs::path folder_;
};

TEST_F(BroughtSurvey, IsAPlainFile) {
  const fs::path endless = fs::temp_directory_path() / ("endless_" + std::to_string(getpid()) + ".xyz");
  fs::create_symlink("/dev/zero", endless);
  try {
    read_survey(endless);
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), endless.string() + ": is no plain file; give a survey that was written to the disk");
  }
  fs::remove(endless);
}

TEST_F(BroughtSurvey, ReadsEverySeparator) {
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.csv", "x [m],y [m],z [m]\n0,1,0.5\n2,3,-0.5\n"},
           {"b.csv", "\xEF\xBB\xBFx [m];y [m];z [m]\r\n0;1;0.5\r\n2;3;-0.5\r\n"},
           {"c.csv", "x [m]\ty [m]\tz [m]\n0\t1\t0.5\n2\t3\t-0.5\n"},
           {"d.xyz", "# points\n0 1  0.5\n\t2\t3 -0.5\n"},
           {"e.XYZ", "X Y Z\n0,1,0.5\n2,3,-0.5\n"},
           {"f.txt", "0;1;0.5;7\n2;3;-0.5;7\n"}}) {
    const SurveyFile survey = read_survey(written(name, text));
    ASSERT_EQ(survey.points.size(), 2U) << name;
    EXPECT_EQ(survey.points[0], Vec3(0, 1, 0.5)) << name;
    EXPECT_EQ(survey.points[1], Vec3(2, 3, -0.5)) << name;
  }
}

TEST_F(BroughtSurvey, AsksAboutDecimalCommas) {
  EXPECT_EQ(refused("a.csv", "x [m];z [m]\n0,5;1\n1,5;2\n2;3\n"),
            "a.csv:2: \"0,5\" in the column \"x\" has a decimal comma; write 0.5 in the whole table (as in line 3)");
  EXPECT_EQ(refused("a.xyz", "0,5 1,5 2\n"), "a.xyz:1: \"0,5\" has a decimal comma; write 0.5 in the whole file");
  EXPECT_EQ(
      refused("b.csv", "0,1,2\n3,4,5\n"),
      "b.csv:1: there is no heading line, only numbers; begin with names and units, as in \"x [m], y [m], z [m]\"");
  EXPECT_THAT(refused("c.csv", "x [m],z [m]\n" + std::string(1000, 'a') + ",1\n"), HasSubstr("aaa...\" in the column"));
}

TEST_F(BroughtSurvey, ReadsAnEsriGrid) {
  const std::string head = "NCOLS 3\nnrows 2\nxllcorner 650000\nyllcenter 4750000\ncellsize 10\nNODATA_value -1\n";
  const SurveyFile survey = read_survey(written("a.asc", head + "1 2 3\n4 -1\n6\n"));
  ASSERT_EQ(survey.points.size(), 5U);
  EXPECT_EQ(survey.points[0], Vec3(650005, 4750010, 1));  // rows run from the north
  EXPECT_EQ(survey.points[4], Vec3(650025, 4750000, 6));
  EXPECT_EQ(survey.remarks.back(), "1 cells without a height are left out");
  EXPECT_EQ(refused("b.asc", head + "1 2 3\n4\n"),
            "b.asc:8: the grid ends after 4 heights, its head announces 3 x 2; export it again");
  EXPECT_THAT(refused("c.asc", "ncols 3\n1 2 3\n"), HasSubstr("the grid's head has no \"nrows\""));
}

TEST_F(BroughtSurvey, TellsHowMuchOfTheFloorItCovers) {
  const std::vector<std::string> lines =
      warnings_of(tank("part.csv", "x [m],y [m],z [m]\n0,0,0.2\n3,0,0.2\n3,3,0.2\n0,3,0.2\n"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "scene.toml:20: shape \"bed\": part.csv covers 75 % of the containers' floor: it ends at x = 3 m; extend "
            "the survey, or shorten the tank to it");
  EXPECT_TRUE(warnings_of(tank("all.csv", "x [m],y [m],z [m]\n-1,-1,0.2\n5,-1,0.2\n5,4,0.2\n-1,4,0.2\n")).empty());
}

TEST_F(BroughtSurvey, TakesTheMeanOfHeightsThatHardlyDiffer) {
  const std::string around = "x [m],y [m],z [m]\n-1,-1,0.2\n5,-1,0.2\n5,4,0.2\n-1,4,0.2\n2,1,0.2\n2,1,";
  const std::vector<std::string> lines = warnings_of(tank("near.csv", around + "0.2008\n"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "scene.toml:20: shape \"bed\": near.csv gives two heights at 1 place; the largest difference is 800 um at "
            "x = 2 m, y = 1 m, lines 6 and 7; their means are taken");
  EXPECT_THAT(refusal(tank("far.csv", around + "0.25\n")),
              HasSubstr("lines 6 and 7; remove the points that are wrong"));
  std::vector<Vec3> points{{0, 0, 1}, {0, 0, 1}, {0, 0, 4}, {1, 0, 3}};
  EXPECT_EQ(merge_repeated(points).places, 1U);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0], Vec3(0, 0, 2));
}

TEST(Averaged, KeepsOutlineAndPlane) {
  // Points on a plane stay on it; squares of 0.5 leave four means, and the corners.
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) points.emplace_back(i / 100.0, j / 100.0, 0.3 * i / 100 - 0.2 * j / 100);
  const std::vector<Vec3> means = averaged(points, 0.5);
  EXPECT_EQ(means.size(), 8U);
  Vec3 upper = means[0];
  for (const Vec3& p : means) {
    upper = upper.cwiseMax(p);
    EXPECT_NEAR(p.z(), 0.3 * p.x() - 0.2 * p.y(), 1e-12);
  }
  EXPECT_EQ(upper.x(), 0.99);
  EXPECT_EQ(upper.y(), 0.99);
}

TEST(Places, AreToldToAHundredthOfTheSpacing) {
  EXPECT_EQ(placed_text(659798, 5), "659798 m");
  EXPECT_EQ(placed_text(650000.0625, 0.005), "650000.0625 m");
  EXPECT_EQ(placed_text(0.135, 0.01), "13.5 cm");
  EXPECT_EQ(placed_text(4751600, 5), "4751600 m");
  EXPECT_EQ(placed_number(650000.0625, 0.005), "650000.0625");
  EXPECT_EQ(placed_number(0.123456789, 0.01), "0.123457");
}

TEST(FilledVolume, CountsWhatIsFilled) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 0, 0.5));
  add_box(scene, "block", ShapeRole::wall, Vec3(0, 0, 0), Vec3(0.25, 0, 0.4));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(1, 0, 0.4));
  const ShapeSummary pool = generate(scene).summary.shapes[2];
  EXPECT_EQ(pool.particles, 3000);
  EXPECT_NEAR(pool.filled, 0.3, 1e-12);  // of 0.4 m^2, a quarter of which stays wall
  EXPECT_NEAR(pool.exact, 0.4, 1e-12);
}

}  // namespace
}  // namespace thalweg::gencase::test
