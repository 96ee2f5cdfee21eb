#include "case/tables/velocity_section.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class VelocitySectionFile : public testing::Test {
 protected:
  VelocitySectionFile() : file_(fs::temp_directory_path() / ("section_" + std::to_string(getpid()) + ".csv")) {}
  ~VelocitySectionFile() override { fs::remove(file_); }
  VelocitySection read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_velocity_section(file_);
  }
  std::string refused(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file_.string().size());
    }
    return "accepted";
  }

 private:
  fs::path file_;
};

TEST_F(VelocitySectionFile, TakesItsRowsInAnyOrder) {
  const VelocitySection section =
      read("height [m],across [m],speed [m/s]\n0.1,0.2,0.8\n0,-0.2,0.1\n0.1,-0.2,0.4\n0,0.2,0.3\n0,0,0.2\n0.1,0,0.6\n");
  EXPECT_EQ(section.heights, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(section.across, (std::vector<double>{-0.2, 0, 0.2}));
  EXPECT_EQ(section.speeds, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.6, 0.8}));
}

// A product of two straight lines is bilinear: between its places the table has it to rounding.
TEST_F(VelocitySectionFile, IsLinearBetweenItsPlacesAndConstantBeyond) {
  const auto exact = [](double height, double across) { return (1 + 5 * height) * (2 + 3 * across); };
  VelocitySection section{{0, 0.03, 0.1}, {-0.2, -0.05, 0.3}, {}};
  for (const double height : section.heights) {
    for (const double across : section.across) section.speeds.push_back(exact(height, across));
  }
  for (const double height : {0.0, 0.01, 0.03, 0.07, 0.1}) {
    for (const double across : {-0.2, -0.1, 0.0, 0.21, 0.3}) {
      EXPECT_NEAR(section.speed_at(height, across), exact(height, across), 1e-14);
    }
  }
  EXPECT_DOUBLE_EQ(section.speed_at(-1, 9), exact(0, 0.3));
  EXPECT_DOUBLE_EQ(section.speed_at(2, -9), exact(0.1, -0.2));
}

TEST_F(VelocitySectionFile, WithoutPlacesAcrossIsTheSameAllAcross) {
  const VelocitySection section = read("height [m],speed [m/s]\n0.1,0.4\n0,0.2\n");
  EXPECT_TRUE(section.across.empty());
  EXPECT_DOUBLE_EQ(section.speed_at(0.05, -3), 0.3);
  EXPECT_DOUBLE_EQ(section.speed_at(0.05, 7), 0.3);
}

TEST_F(VelocitySectionFile, SaysWhichPlaceIsMissing) {
  EXPECT_EQ(refused("height [m],across [m],speed [m/s]\n0,0,1\n0,0.1,1\n0.05,0.1,1\n"),
            ":1: no row has height 0.05 m and across 0 m; give one for each height at each place across");
  EXPECT_EQ(refused("height [m],across [m],speed [m/s]\n0,0,1\n0,0,1\n"),
            ":3: a row before it has the same place; remove one");
  EXPECT_EQ(refused("height [m],across [m],speed [m/s]\n0,0,1\n"), ":1: has less than two places; add some");
  EXPECT_EQ(refused("height [m],speed [m/s]\n0,0\n1,0\n"), ":1: all speeds are 0; give the speeds of the water");
  EXPECT_EQ(refused("height [m],speed [m/s]\n0,1\n,1\n"),
            ":3: the row lacks a number, or has a height or speed below 0; correct it");
  EXPECT_EQ(refused("height [m],speed [m/s]\n0,1\n0.1,-1\n"),
            ":3: the row lacks a number, or has a height or speed below 0; correct it");
}

}  // namespace
}  // namespace thalweg
