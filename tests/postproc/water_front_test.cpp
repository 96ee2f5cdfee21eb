#include <gtest/gtest.h>

#include <cmath>

#include "common/extraction/profile_extraction.hpp"
#include "tests/postproc/manufactured.hpp"

namespace thalweg {
namespace {

using manufactured::flat;
using manufactured::Flume;

// A wedge of water 10 dp high running out to nothing at x = 0.8: it is least_layer * dp deep at 0.8 - 0.5 dp / slope.
TEST(WaterFront, IsWhereAWedgeIsHalfASpacingDeep) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  const auto bed = [](double) { return 0.05; };
  const double slope = 0.1;
  flume.fill(ParticleType::sediment, 0, 1, flat, bed);
  flume.fill(ParticleType::water, 0.3, 0.8, bed, [&](double x) { return 0.05 + slope * (0.8 - x); });
  EXPECT_NEAR(extract_profile(flume.set, {}).front, 0.8 - least_layer * flume.spacing / slope, 2 * flume.spacing);
}

TEST(WaterFront, InterpolatesBetweenColumns) {
  Profile profile;
  profile.x = {0, 1, 2, 3};
  profile.free_surface = {0.5, 0.4, 0.1, 0.1};
  profile.bed = {0.1, 0.1, 0.1, 0.1};
  EXPECT_DOUBLE_EQ(water_front(profile, 0.1), 1 + (0.3 - 0.1) / 0.3);
  EXPECT_TRUE(std::isnan(water_front(profile, 0.5)));
  profile.bed.clear();
  EXPECT_TRUE(std::isnan(water_front(profile, 0.1)));  // water over what?
  profile.floor = {0.1, 0.1, 0.1, Profile::missing};
  EXPECT_DOUBLE_EQ(water_front(profile, 0.1), 1 + (0.3 - 0.1) / 0.3);
}

// Mesh models smear a film over all of a dry flume; it is no front, and neither is water over a wall that moves none.
TEST(WaterFront, IsNoFilm) {
  Profile profile;
  profile.x = {0, 1, 2, 3};
  profile.free_surface = {0.5, 0.4, 0.1 + 1e-4, 0.1 + 1e-4};
  profile.bed = {0.1, 0.1, 0.1, 0.1};
  EXPECT_NEAR(water_front(profile, 2.5e-3), 2, 0.01);
  profile.floor = profile.bed;
  profile.bed[1] = Profile::missing;  // on a wall that moves
  EXPECT_NEAR(water_front(profile, 2.5e-3), 2, 0.01);
}

TEST(WaterFront, OfAMeasurementNeedsADryColumnBehindIt) {
  Profile profile;
  profile.x = {0, 1, 2};
  profile.free_surface = {0.5, 0.4, 0.4};
  profile.bed = {0.1, 0.1, Profile::missing};
  EXPECT_TRUE(std::isnan(water_front(profile, 0.1, MissingColumn::unknown)));
  EXPECT_DOUBLE_EQ(water_front(profile, 0.1, MissingColumn::dry), 1 + (0.3 - 0.1) / 0.3);
  profile.bed.back() = 0.1;
  EXPECT_TRUE(std::isnan(water_front(profile, 0.1, MissingColumn::unknown)));  // the water goes on at the last column
  EXPECT_DOUBLE_EQ(water_front(profile, 0.1, MissingColumn::dry), 2);          // the water stands at a wall
  profile.free_surface.back() = 0.1;
  EXPECT_DOUBLE_EQ(water_front(profile, 0.1, MissingColumn::unknown), 1 + (0.3 - 0.1) / 0.3);
}

}  // namespace
}  // namespace thalweg
