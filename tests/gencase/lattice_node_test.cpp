#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "solver/simulation/make_scene.hpp"
#include "tests/gencase/scene.hpp"

// The node that gencase names in the particle file, and the one from which the solver lays its columns.
namespace thalweg::gencase::test {
namespace {

constexpr double dp = 0.01;

/// Water in a tank whose corner is off every multiple of the spacing, and at no multiple of it from the domain's corner.
Case tank_off_the_grid(ShapeRole role) {
  const Vec3 corner(0.1234, 0, -0.0567);
  Case scene = empty_scene(2, dp);
  Shape& tank = add_tank(scene, corner, corner + Vec3(0.2, 0, 0.1));
  tank.role = role;
  if (role == ShapeRole::moving_wall) {
    tank.motion = "sway";
    scene.motions.emplace_back().name = "sway";
  }
  add_box(scene, "pool", ShapeRole::water, corner, corner + Vec3(0.2, 0, 0.05));
  return scene;
}

Vec<2, double> node_in_solver(const Generated& generated) {
  return std::get<Scene<2>>(make_scene(generated.resolved, generated.particles)).lattice_node;
}

TEST(LatticeNode, IsAWholeNumberOfSpacingsFromEveryParticle) {
  for (const ShapeRole role : {ShapeRole::wall, ShapeRole::moving_wall}) {
    const ParticleSet set = generate(tank_off_the_grid(role)).particles;
    ASSERT_TRUE(set.info.lattice_node);
    for (const Vec3& p : set.position) {
      const Vec3 steps = (p - *set.info.lattice_node) / dp;
      EXPECT_NEAR(steps.x(), std::round(steps.x()), 1e-9);
      EXPECT_NEAR(steps.z(), std::round(steps.z()), 1e-9);
    }
  }
}

TEST(LatticeNode, ReachesTheSolver) {
  Generated generated = generate(tank_off_the_grid(ShapeRole::moving_wall));
  const Vec3 node = *generated.particles.info.lattice_node;
  EXPECT_EQ(node_in_solver(generated)[0], node.x());
  EXPECT_EQ(node_in_solver(generated)[1], node.z());
}

// Old files and new ones give the same columns, to the last bit.
TEST(LatticeNode, IsTheOneFoundInFilesWithoutIt) {
  Generated generated = generate(tank_off_the_grid(ShapeRole::wall));
  const Vec<2, double> named = node_in_solver(generated);
  generated.particles.info.lattice_node.reset();
  EXPECT_EQ(node_in_solver(generated)[0], named[0]);
  EXPECT_EQ(node_in_solver(generated)[1], named[1]);

  generated.particles.type.assign(generated.particles.size(), ParticleType::water);
  EXPECT_DOUBLE_EQ(node_in_solver(generated)[0], generated.resolved.domain.from.x() + 0.5 * dp);
}

}  // namespace
}  // namespace thalweg::gencase::test
