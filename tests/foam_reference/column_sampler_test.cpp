#include "foam_reference/column_sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {
namespace {

// The centres of the plan's cells in the mesh's order, without those that `solid` tells.
template <class Solid>
std::vector<Vec3> centres_of(const MeshPlan& plan, Solid solid) {
  std::vector<Vec3> centres;
  for (std::int64_t k = 0; k < plan.cells[2]; ++k) {
    for (std::int64_t j = 0; j < plan.cells[1]; ++j) {
      for (std::int64_t i = 0; i < plan.cells[0]; ++i) {
        const Vec3 index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const Vec3 centre = plan.low + (index.array() + 0.5).matrix().cwiseProduct(plan.size());
        if (!solid(centre)) centres.push_back(centre);
      }
    }
  }
  return centres;
}

bool nowhere(const Vec3&) { return false; }

// Share of a cell of height dz around z that lies below `level`.
double share_below(double level, double z, double dz) { return std::clamp((level - z) / dz + 0.5, 0.0, 1.0); }

template <class Bed, class Surface>
PhaseFields layers(const std::vector<Vec3>& centres, double dz, Bed bed, Surface surface) {
  PhaseFields fields;
  for (const Vec3& centre : centres) {
    fields.sediment.push_back(share_below(bed(centre), centre.z(), dz));
    fields.air.push_back(1 - share_below(surface(centre), centre.z(), dz));
  }
  return fields;
}

TEST(ColumnSampler, FindsLayersExactlyInsideCells) {
  const MeshPlan plan = plan_mesh(still_tank());
  const auto centres = centres_of(plan, nowhere);
  const auto bed = [](const Vec3& x) { return 0.05 + 0.02 * std::sin(10 * x.x()); };
  const auto surface = [](const Vec3& x) { return 0.1 - 0.05 * x.x(); };
  const SampledProfile sampled = ColumnSampler(plan, centres).sample(layers(centres, 0.01, bed, surface));
  ASSERT_EQ(sampled.profile.x.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i) {
    const Vec3 x(sampled.profile.x[i], 0, 0);
    EXPECT_NEAR(x.x(), 0.005 + 0.01 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(sampled.profile.bed[i], bed(x), 1e-12);
    EXPECT_NEAR(sampled.profile.free_surface[i], surface(x), 1e-12);
  }
  EXPECT_TRUE(sampled.profile.moving_bed.empty());
  // A sharp level and the crossing of 0.5 between centres differ by at most half a cell.
  EXPECT_LE(sampled.largest_bed_spread, 0.005 + 1e-12);
  EXPECT_GT(sampled.largest_bed_spread, 0);
}

TEST(ColumnSampler, SeesAFilmThinnerThanACell) {
  const MeshPlan plan = plan_mesh(still_tank());
  const auto centres = centres_of(plan, nowhere);
  const auto level = [](double z) { return [z](const Vec3&) { return z; }; };
  const Profile profile = ColumnSampler(plan, centres).sample(layers(centres, 0.01, level(0.05), level(0.052))).profile;
  EXPECT_NEAR(profile.free_surface[20] - profile.bed[20], 0.002, 1e-12);
}

// A pipe over the bed: the integral would miss its thickness, the crossing of 0.5 does not.
TEST(ColumnSampler, TakesTheCrossingWhereASolidInterruptsAColumn) {
  const MeshPlan plan = plan_mesh(still_tank());
  const auto centres =
      centres_of(plan, [](const Vec3& x) { return std::abs(x.x() - 0.2) < 0.02 && std::abs(x.z() - 0.06) < 0.01; });
  const auto level = [](double z) { return [z](const Vec3&) { return z; }; };
  const Profile profile = ColumnSampler(plan, centres).sample(layers(centres, 0.01, level(0.03), level(0.1))).profile;
  EXPECT_NEAR(profile.free_surface[20], 0.1, 1e-12);
  EXPECT_NEAR(profile.bed[20], 0.03, 1e-12);
  EXPECT_NEAR(profile.free_surface[5], 0.1, 1e-12);
}

TEST(ColumnSampler, StartsColumnsAtTheTopOfASill) {
  const MeshPlan plan = plan_mesh(still_tank());
  const auto centres = centres_of(plan, [](const Vec3& x) { return x.x() > 0.3 && x.z() < 0.06; });
  const auto level = [](double z) { return [z](const Vec3&) { return z; }; };
  const Profile profile = ColumnSampler(plan, centres).sample(layers(centres, 0.01, level(0.05), level(0.1))).profile;
  EXPECT_NEAR(profile.bed[35], 0.06, 1e-12);  // bare sill
  EXPECT_NEAR(profile.free_surface[35], 0.1, 1e-12);
}

TEST(ColumnSampler, HasNoElevationWhereASolidFillsTheColumn) {
  const MeshPlan plan = plan_mesh(still_tank());
  const auto centres = centres_of(plan, [](const Vec3& x) { return x.x() > 0.3; });
  const auto level = [](double z) { return [z](const Vec3&) { return z; }; };
  const Profile profile = ColumnSampler(plan, centres).sample(layers(centres, 0.01, level(0.05), level(0.1))).profile;
  EXPECT_TRUE(std::isnan(profile.bed[35]));
  EXPECT_NEAR(profile.bed[29], 0.05, 1e-12);
}

TEST(ColumnSampler, AveragesOverTheWidth) {
  Case scene = still_tank();
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.1;
  const MeshPlan plan = plan_mesh(scene);
  const auto centres = centres_of(plan, nowhere);
  const auto bed = [](const Vec3& x) { return x.y() < 0.05 ? 0.04 : 0.06; };
  const auto surface = [](const Vec3&) { return 0.1; };
  const Profile profile = ColumnSampler(plan, centres).sample(layers(centres, 0.01, bed, surface)).profile;
  EXPECT_NEAR(profile.bed[7], 0.05, 1e-12);
}

TEST(ColumnSampler, HasNoBedWithoutSediment) {
  const MeshPlan plan = plan_mesh(water_tank());
  const auto centres = centres_of(plan, nowhere);
  const auto level = [](const Vec3&) { return 0.1; };
  PhaseFields fields = layers(centres, 0.01, level, level);
  fields.sediment.clear();
  const Profile profile = ColumnSampler(plan, centres).sample(fields).profile;
  EXPECT_TRUE(profile.bed.empty());
  EXPECT_NEAR(profile.free_surface[0], 0.1, 1e-12);
}

}  // namespace
}  // namespace thalweg::foam
