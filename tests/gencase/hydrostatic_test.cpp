#include "gencase/hydrostatic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/water/equation_of_state.hpp"
#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

constexpr double g = 9.81;

/// 0.10 m of water over 0.06 m of sand of 2000 kg/m^3 in a tank of 0.5 m.
Case two_layers() {
  Case scene = empty_scene(2, 0.005);
  add_sand(scene);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.5, 0, 0.2));
  add_box(scene, "bed", ShapeRole::sediment, Vec3(0, 0, 0), Vec3(0.5, 0, 0.06));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0.06), Vec3(0.5, 0, 0.16));
  return scene;
}

TEST(Hydrostatic, DensityIsTheInverseOfTaitsEquation) {
  for (const double pressure : {0.0, 1.0, 1e3, 1e6}) {
    const double density = hydrostatic_density(1000, pressure, 20);
    EXPECT_NEAR(tait_pressure(density / 1000 - 1, tait_stiffness(1000.0, 20.0)), pressure, 1e-9 * pressure + 1e-9);
  }
}

TEST(Hydrostatic, TwoLayersCarryTheWeightAboveThem) {
  const Generated generated = generate(two_layers());
  const ParticleSet& set = generated.particles;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] == ParticleType::wall) continue;
    const double z = set.position[i].z();
    const double expected = z > 0.06 ? 1000 * g * (0.16 - z) : 1000 * g * 0.1 + 2000 * g * (0.06 - z);
    EXPECT_NEAR(set.pressure[i], expected, 1e-6 * expected) << z;  // single precision
  }
  // The deepest particle: 0.1 m of water and 0.0575 m of sand.
  EXPECT_NEAR(generated.summary.largest_pressure, 1000 * g * 0.1 + 2000 * g * 0.0575, 1e-8 * 2000);
  EXPECT_NEAR(generated.summary.fluid_height, 0.16, 1e-12);
}

TEST(Hydrostatic, ABedThatIsASurfaceIsNoFluid) {
  Case scene = two_layers();
  scene.model.sediment = SedimentModel::surface;
  EXPECT_NEAR(generate(scene).summary.fluid_height, 0.10, 1e-12);
}

TEST(Hydrostatic, PressureDensityAndMassBelongTogether) {
  const Generated generated = generate(two_layers());
  const ParticleSet& set = generated.particles;
  const double c = 10 * 2 * std::sqrt(g * 0.16);
  EXPECT_DOUBLE_EQ(generated.summary.sound_speed, c);
  EXPECT_DOUBLE_EQ(generated.resolved.numerics.maximum_speed, 2 * std::sqrt(g * 0.16));
  for (std::size_t i = 0; i < set.size(); ++i) {
    const double rest = set.type[i] == ParticleType::sediment ? 2000 : 1000;
    const double pressure = rest * c * c / 7 * (std::pow(set.density[i] / rest, 7) - 1);
    EXPECT_NEAR(pressure, set.pressure[i], 7 * 6e-8 * rest * c * c / 7 + 1e-6 * set.pressure[i]);  // 7 ulp of density
    EXPECT_FLOAT_EQ(set.mass[i], set.density[i] * 25e-6F);
  }
}

TEST(Hydrostatic, EveryColumnHasItsOwnFreeSurface) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.4, 0, 0.3));
  add_box(scene, "high", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.2));
  add_box(scene, "low", ShapeRole::water, Vec3(0.2, 0, 0), Vec3(0.4, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  EXPECT_NEAR(set.pressure[nearest(set, Vec3(0.195, 0, 0.005))], 1000 * g * 0.195, 1e-2);
  EXPECT_NEAR(set.pressure[nearest(set, Vec3(0.205, 0, 0.005))], 1000 * g * 0.045, 1e-2);
}

TEST(Hydrostatic, WaterUnderAPipeFeelsTheWaterBesideIt) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.6, 0, 0.5));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.6, 0, 0.4));
  add_ball(scene, "pipe", ShapeRole::wall, Vec3(0.3, 0, 0.15), 0.1);
  const ParticleSet set = generate(scene).particles;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::water) continue;
    const double expected = 1000 * g * (0.4 - set.position[i].z());
    EXPECT_NEAR(set.pressure[i], expected, 1e-6 * expected) << set.position[i].transpose();
  }
}

TEST(Hydrostatic, EnclosedWaterStartsFromZeroAtItsHighestPoint) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1)).open.clear();
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  const ParticleSet set = generate(scene).particles;
  EXPECT_NEAR(set.pressure[nearest(set, Vec3(0.105, 0, 0.005))], 1000 * g * 0.095, 1e-2);
}

TEST(Hydrostatic, ThreeDimensions) {
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 1, 1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(1, 1, 0.5));
  const ParticleSet set = generate(scene).particles;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::water) continue;
    EXPECT_NEAR(set.pressure[i], 1000 * g * (0.5 - set.position[i].z()), 1e-2);
  }
}

TEST(Hydrostatic, GravityAlongAnotherAxis) {
  Case scene = empty_scene(2, 0.01);
  scene.domain.gravity = Vec3(g, 0, 0);  // "down" is +x
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.3, 0, 0.2));
  std::string said;
  GenerateOptions options;
  options.notes.say = [&](const std::string& line) { said += line + '\n'; };
  const ParticleSet set = generate(scene, options).particles;
  for (std::size_t i = 0; i < set.size(); ++i) EXPECT_NEAR(set.pressure[i], 1000 * g * set.position[i].x(), 1e-2);
  EXPECT_NE(said.find("gravity points along +x"), std::string::npos) << said;
}

TEST(Hydrostatic, WithoutGravityThePressureIsZero) {
  Case scene = empty_scene(2, 0.01);
  scene.domain.gravity = Vec3::Zero();
  scene.numerics.maximum_speed = 1;
  add_ball(scene, "drop", ShapeRole::water, Vec3(0, 0, 0), 0.1);
  std::string said;
  GenerateOptions options;
  options.notes.say = [&](const std::string& line) { said += line + '\n'; };
  const ParticleSet set = generate(scene, options).particles;
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_EQ(set.pressure[i], 0);
    EXPECT_EQ(set.density[i], 1000);
  }
  EXPECT_NE(said.find("no gravity: the pressure starts at 0"), std::string::npos) << said;
}

TEST(Hydrostatic, TiltedGravityWorksAcrossTheBedAlone) {
  const double slope = 0.1;
  Case scene = empty_scene(2, 0.01);
  scene.domain.gravity = g * Vec3(std::sin(slope), 0, -std::cos(slope));
  add_box(scene, "sheet", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.3, 0, 0.1));
  const ParticleSet set = generate(scene).particles;
  for (std::size_t i = 0; i < set.size(); ++i)
    EXPECT_NEAR(set.pressure[i], 1000 * g * std::cos(slope) * (0.1 - set.position[i].z()), 1e-2);
}

}  // namespace
}  // namespace thalweg::gencase::test
