#include "gencase/pore_water.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

constexpr double g = 9.81;

/// 0.04 m of water over 0.06 m of sand, half of it pores, in a tank of 0.1 m.
Case mixed_bed() {
  Case scene = empty_scene(2, 0.005);
  add_sand(scene);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.1, 0, 0.2));
  add_box(scene, "bed", ShapeRole::sediment, Vec3(0, 0, 0), Vec3(0.1, 0, 0.06));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0.06), Vec3(0.1, 0, 0.1));
  scene.model.sediment = SedimentModel::viscoplastic;
  scene.model.seepage = SeepageModel::mixture;
  return scene;
}

TEST(PoreWater, SharesTheBedWithTheGrains) {
  const Generated generated = generate(mixed_bed());
  const ParticleSet& set = generated.particles;
  EXPECT_EQ(count(set, ParticleType::sediment), 20 * 12);
  EXPECT_EQ(count(set, ParticleType::water), 20 * (12 + 8));
  const auto mass = mass_by_type(set);
  EXPECT_NEAR(mass[3], 0.5 * 3000 * 0.1 * 0.06, 1e-4);
  // Compressed by 1 kPa at most against 1000 c^2.
  const double c = generated.summary.sound_speed;
  EXPECT_NEAR(mass[2], 1000 * 0.1 * (0.5 * 0.06 + 0.04), 7 * 1000 / (1000 * c * c));
  EXPECT_EQ(std::set<std::int64_t>(set.id.begin(), set.id.end()).size(), set.size());
}

TEST(PoreWater, CarriesItsOwnWeightAndThePackingTheRest) {
  const Generated generated = generate(mixed_bed());
  const ParticleSet& set = generated.particles;
  const double c = generated.summary.sound_speed;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] == ParticleType::wall) continue;
    const double z = set.position[i].z();
    EXPECT_NEAR(set.pressure[i], 1000 * g * (0.1 - z), 1e-3);
    if (set.type[i] != ParticleType::sediment) continue;
    // 0.5 (3000 - 1000) g (0.06 - z) over the stiffness 0.5 (3000 - 1000) c^2.
    EXPECT_NEAR(set.density[i] / 1500 - 1, g * (0.06 - z) / (c * c), 1e-6);
  }
}

TEST(PoreWater, IsNotThereUnlessAskedFor) {
  Case scene = mixed_bed();
  scene.model.seepage = SeepageModel::off;
  EXPECT_EQ(count(generate(scene).particles, ParticleType::water), 20 * 8);
}

}  // namespace
}  // namespace thalweg::gencase::test
