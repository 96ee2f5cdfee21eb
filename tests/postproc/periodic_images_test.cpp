// Heights next to sides at which the domain repeats itself.
#include "common/extraction/periodic_images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "postproc/snapshot_measures.hpp"

namespace thalweg {
namespace {

constexpr double dp = 0.01;

/// Walls, five layers of bed and five of water over a square of 0.2 m, from corner to corner.
ParticleSet flat_bed() {
  ParticleSet set;
  set.info.dimension = 3;
  set.info.spacing = dp;
  set.info.smoothing_length = 1.5 * dp;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      for (int k = -4; k < 10; ++k) {
        set.id.push_back(static_cast<std::int64_t>(set.id.size()));
        set.type.push_back(k < 0 ? ParticleType::wall : k < 5 ? ParticleType::sediment : ParticleType::water);
        set.position.emplace_back((i + 0.5) * dp, (j + 0.5) * dp, (k + 0.5) * dp);
        set.velocity.emplace_back(0.0F, 0.0F, 0.0F);
        set.density.push_back(1000);
        set.mass.push_back(static_cast<float>(1000 * dp * dp * dp));
        set.scalars["Numbers"].push_back(static_cast<float>(set.id.back()));
        set.doubles["Pairs"].insert(set.doubles["Pairs"].end(), {double(set.id.back()), 0.5});
      }
    }
  }
  return set;
}

MeasureSettings settings(const std::vector<std::string>& periodic) {
  Case of;
  of.info.dimension = 3;
  of.domain.from = Vec3(0, 0, -0.1);
  of.domain.to = Vec3(0.2, 0.2, 0.2);
  of.domain.gravity = Vec3(0, 0, -9.81);
  of.domain.periodic = periodic;
  of.sediments["sand"].grain_diameter = 1e-3;
  return settings_of(of, {}, false);
}

struct Range {
  double least = INFINITY;
  double most = -INFINITY;
};
Range beds(const LevelMap& map) {
  Range range;
  for (const ColumnLevels& column : map.levels) {
    if (std::isnan(column.bed)) continue;
    range.least = std::min(range.least, column.bed);
    range.most = std::max(range.most, column.bed);
  }
  return range;
}

TEST(PeriodicImages, AFlatBedIsFlatUpToTheSides) {
  const Range alone = beds(levels_of(flat_bed(), settings({})));
  EXPECT_GT(alone.most - alone.least, 0.1 * dp) << "without images the contour dips";
  const Range repeated = beds(levels_of(flat_bed(), settings({"x", "y"})));
  EXPECT_LT(repeated.most - repeated.least, 1e-3 * dp);
  EXPECT_NEAR(repeated.most, 0.05, 0.1 * dp);
}

TEST(PeriodicImages, TheBooksOfABedThatSankAreThoseOfItsArea) {
  const MeasureSettings of = settings({"x", "y"});
  const LevelMap before = levels_of(flat_bed(), of);
  ParticleSet lower = flat_bed();
  for (Vec3& at : lower.position) at.z() -= at.z() > 0.02 ? dp : 0;  // as far as the nodes of the map are apart
  const auto measured = measure(lower, 1, of, &before).measures.balance;
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->scour, dp, 5e-3 * dp);  // layers below are closer now, in reach
  EXPECT_NEAR(measured->deposition, 0, 1e-3 * dp);
  EXPECT_NEAR(measured->eroded, dp * 0.04, 5e-3 * dp * 0.04);
}

TEST(PeriodicImages, CarryAllArrays) {
  const ParticleSet set = flat_bed();
  Domain domain;
  domain.from = Vec3(0, 0, -0.1);
  domain.to = Vec3(0.2, 0.2, 0.2);
  EXPECT_FALSE(with_periodic_images(set, domain, 2 * dp));
  domain.periodic = {"x", "y"};
  const auto all = with_periodic_images(set, domain, 2 * dp);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->size(), 24U * 24 * 14);  // two rows more at each side, corners included
  EXPECT_EQ(all->velocity.size(), all->size());
  for (std::size_t i = set.size(); i < all->size(); ++i) {
    EXPECT_EQ(all->scalars.at("Numbers")[i], static_cast<float>(all->id[i]));
    EXPECT_EQ(all->doubles.at("Pairs")[2 * i], double(all->id[i]));
    const Vec3 way = all->position[i] - set.position[static_cast<std::size_t>(all->id[i])];
    EXPECT_NEAR(std::remainder(way.x(), 0.2), 0, 1e-12);
    EXPECT_NEAR(std::remainder(way.y(), 0.2), 0, 1e-12);
    EXPECT_GT(way.head<2>().norm(), 0.1);
  }
}

}  // namespace
}  // namespace thalweg
