#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TableTest : public ::testing::Test {
 protected:
  TableTest() { fs::create_directories(folder); }
  ~TableTest() override { fs::remove_all(folder); }

  fs::path text_file(const std::string& text) const {
    std::ofstream(folder / "a.csv") << text;
    return folder / "a.csv";
  }

  // The message of reading `text` as a profile, without the folder.
  std::string profile_message(const std::string& text) const {
    try {
      read_profile(text_file(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.string().size() + 1);
    }
    return "no error";
  }

  fs::path folder = fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};
using Csv = TableTest;
using ProfileFile = TableTest;

TEST_F(Csv, ReadsColumnsByNameWithTheirUnits) {
  const CsvTable table =
      CsvTable::read(text_file("# Louvain, run 1\n#second\ntime [s], limiter ,energy [J]\r\n"
                               "0, \"force, body\",1e-3\n\n# later remark\n0.5,sound,\n"));
  EXPECT_THAT(table.comments, ElementsAre("Louvain, run 1", "second"));
  ASSERT_EQ(table.columns().size(), 3U);
  EXPECT_EQ(table.columns()[1].name, "limiter");
  EXPECT_EQ(table.columns()[2].unit, "J");
  EXPECT_THAT(table.numbers("time", "s"), ElementsAre(0, 0.5));
  EXPECT_THAT(table.texts("limiter"), ElementsAre("force, body", "sound"));
  EXPECT_EQ(table.numbers("energy", "J")[0], 1e-3);
  EXPECT_TRUE(std::isnan(table.numbers("energy", "J")[1]));
  EXPECT_THAT(table.where(1), HasSubstr("a.csv:7"));
}

TEST_F(Csv, WritesWhatItReads) {
  CsvTable table({{"name", ""}, {"value", "m/s^2"}});
  table.comments = {"a comment"};
  table.add_row({"with \"quotes\", and a comma", csv_number(1.0 / 3)});
  table.add_row({"", csv_number(std::nan(""))});
  table.write(folder / "b.csv");
  const CsvTable again = CsvTable::read(folder / "b.csv");
  EXPECT_EQ(again.comments, table.comments);
  EXPECT_EQ(again.texts("name"), table.texts("name"));
  EXPECT_EQ(again.numbers("value", "m/s^2")[0], 1.0 / 3);
  EXPECT_TRUE(std::isnan(again.numbers("value", "m/s^2")[1]));
}

TEST_F(Csv, NamesLineAndCure) {
  const auto message = [&](const std::string& text) {
    try {
      (void)CsvTable::read(text_file(text)).numbers("b", "m");
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.string().size() + 1);
    }
    return std::string("no error");
  };
  EXPECT_EQ(message(""), "a.csv:1: there is no heading line; begin with names and units, as in \"x [m], bed [m]\"");
  EXPECT_EQ(message("a,b [m]\n1,2\n1,2,3\n"), "a.csv:3: the row has 3 cells and the heading 2; add or remove commas");
  EXPECT_EQ(message("# c\na,b [m]\n1,2\n1,two\n"),
            "a.csv:4: \"two\" in the column \"b\" is no number; correct it or leave the cell empty");
  EXPECT_EQ(message("a,b [cm]\n1,2\n"),
            "a.csv:1: the column \"b [cm]\" is not in m; head it \"b [m]\" and give its values in that unit");
  EXPECT_EQ(message("a,c\n1,2\n"), "a.csv:1: there is no column \"b\"; the columns are a, c");
  EXPECT_EQ(message("b [m],b\n1,2\n"), "a.csv:1: the heading names \"b\" twice; rename one column");
  EXPECT_EQ(message("a,b [m]\n\"1,2\n"), "a.csv:2: the quotes do not match; write a quote inside a cell twice");
  EXPECT_THROW(CsvTable::read(folder / "absent.csv"), InputError);
}

TEST_F(ProfileFile, ComesBackWithItsGaps) {
  Profile profile;
  profile.x = {-0.1, 0, 1.0 / 3};
  profile.free_surface = {0.16, Profile::missing, 0.1};
  profile.moving_bed = {0.05, 0.04, Profile::missing};
  write_profile(folder / "t0.250.csv", profile, {"extracted from s00005.vtp"});
  const Profile again = read_profile(folder / "t0.250.csv");
  EXPECT_EQ(again.x, profile.x);
  EXPECT_EQ(again.free_surface[0], 0.16);
  EXPECT_TRUE(std::isnan(again.free_surface[1]));
  EXPECT_TRUE(again.bed.empty());
  EXPECT_TRUE(std::isnan(again.moving_bed[2]));

  std::ostringstream text;
  text << std::ifstream(folder / "t0.250.csv").rdbuf();
  EXPECT_THAT(text.str(),
              ::testing::StartsWith("# extracted from s00005.vtp\nx [m],free_surface [m],moving_bed [m]\n"));
}

TEST_F(ProfileFile, RefusesWhatIsNoProfile) {
  EXPECT_EQ(profile_message("bed [m]\n1\n"), "a.csv:1: there is no column \"x\"; the columns are bed");
  EXPECT_EQ(profile_message("x [m], scour [m]\n1,2\n"),
            "a.csv:1: unknown column \"scour [m]\"; a profile has x [m], free_surface [m], bed [m], "
            "moving_bed [m], floor [m]");
  EXPECT_EQ(profile_message("x [m], bed [m]\n1,2\n1,3\n"),
            "a.csv:3: x = 1 does not increase; sort the rows by x and keep one for each");
  EXPECT_EQ(profile_message("x [m], bed [m]\n,2\n"), "a.csv:2: x is missing; every row needs one");
  EXPECT_EQ(profile_message("x, bed [m]\n1,2\n"),
            "a.csv:1: the column \"x\" is not in m; head it \"x [m]\" and give its values in that unit");
}

// Of these, one never ends and one never begins.
TEST_F(ProfileFile, RefusesWhatIsNoPlainFile) {
  ASSERT_EQ(mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
  for (const fs::path& file : {fs::path("/dev/zero"), folder / "pipe.csv", folder}) {
    try {
      read_profile(file);
      ADD_FAILURE() << file << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), file.string() + ": is no plain file; give a table that was written to the disk");
    }
  }
}

TEST_F(ProfileFile, RefusesToWriteCurvesThatDoNotFit) {
  Profile profile;
  profile.x = {0, 1};
  profile.bed = {0.06};
  EXPECT_THROW(write_profile(folder / "p.csv", profile, {}), RunError);
  EXPECT_FALSE(fs::exists(folder / "p.csv"));
}

TEST(ProfileName, CarriesTheTime) {
  EXPECT_EQ(profile_file_name(0.25), "t0.250.csv");
  EXPECT_EQ(time_of_profile("profiles/t0.250.csv"), 0.25);
  EXPECT_EQ(time_of_profile(profile_file_name(12.5)), 12.5);
  for (const char* other : {"t.csv", "time.csv", "0.250.csv", "t0.250.vtp", "tinf.csv", "t1e3.csv", "t0.25s.csv"}) {
    EXPECT_EQ(time_of_profile(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace thalweg
