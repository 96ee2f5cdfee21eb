#include "postproc/line_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "tests/postproc/manufactured.hpp"

namespace thalweg {
namespace {

using manufactured::flat;
using manufactured::Flume;
using testing::ElementsAre;
using testing::HasSubstr;

// A plane that rises by 0.2 along x, cut along, across and at an angle.
TEST(LineProfile, OfATiltedPlaneIsExactToATenthOfTheSpacing) {
  Flume flume;
  flume.dimension = 3;
  flume.length = 0.5;
  flume.width = 0.2;
  flume.wall_height = 0.25;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double x) { return 0.03 + 0.1 * x; };
  const auto surface = [](double x) { return 0.08 + 0.2 * x; };
  flume.fill(ParticleType::sediment, 0, 0.5, flat, bed);
  flume.fill(ParticleType::water, 0, 0.5, bed, surface);
  for (const ProfileLine& line :
       {ProfileLine{"along", {0.1, 0.08}, {0.4, 0.08}}, ProfileLine{"across", {0.25, 0.03}, {0.25, 0.17}},
        ProfileLine{"oblique", {0.4, 0.15}, {0.1, 0.05}}}) {
    const Profile profile = extract_along(flume.set, {}, line);
    const double length = std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
    ASSERT_GE(profile.x.size(), static_cast<std::size_t>(length / flume.spacing)) << line.name;
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
      if (profile.x[i] > length) continue;
      const double x = line.from[0] + profile.x[i] / length * (line.to[0] - line.from[0]);
      EXPECT_NEAR(profile.free_surface[i], surface(x), 0.1 * flume.spacing) << line.name << " at " << profile.x[i];
      EXPECT_NEAR(profile.bed[i], bed(x), 0.1 * flume.spacing) << line.name << " at " << profile.x[i];
    }
  }
}

TEST(LineProfile, ReadsALineWithUnitsAndNamesWhatIsWrong) {
  const ProfileLine line = parse_line("s1=0 m,10 cm, 1 m,0.1 m");
  EXPECT_EQ(line.name, "s1");
  EXPECT_THAT(line.from, ElementsAre(0, 0.1));
  EXPECT_THAT(line.to, ElementsAre(1, 0.1));
  const auto complaint = [](const std::string& text) {
    try {
      parse_line(text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no InputError");
  };
  EXPECT_THAT(complaint("0 m,0 m,1 m,1 m"), HasSubstr("has no name"));
  EXPECT_THAT(complaint("s=0,0,1,1"), HasSubstr("write --line"));
  EXPECT_THAT(complaint("s=0 m,0 m,1 m"), HasSubstr("has 3 numbers"));
  EXPECT_THAT(complaint("s=0 m,0 m,0 m,0 m"), HasSubstr("has no length"));
  EXPECT_THAT(complaint("a/b=0 m,0 m,1 m,0 m"), HasSubstr("cannot name its folder"));
}

}  // namespace
}  // namespace thalweg
