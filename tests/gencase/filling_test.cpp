#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> warnings_of(const Case& scene) {
  std::vector<std::string> lines;
  GenerateOptions options;
  options.notes.warn = [&](const std::string& line) { lines.push_back(line); };
  generate(scene, options);
  return lines;
}

TEST(Filling, TankAndWaterOfTheLattice2d) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::water), 20 * 5);
  // Support 2 h = 3 spacings: 3 layers left and right over the tank's 10 rows, 3 rows of 26 below.
  EXPECT_EQ(count(set, ParticleType::wall), 2 * 3 * 10 + 3 * 26);
  EXPECT_TRUE(set.state.empty());
}

TEST(Filling, TankAndWaterOfTheLattice3d) {
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(-0.5, 0, 0), Vec3(0.5, 0.6, 0.8));
  add_box(scene, "pool", ShapeRole::water, Vec3(-0.5, 0, 0), Vec3(0.5, 0.6, 0.4));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::water), 10 * 6 * 4);
  EXPECT_EQ(count(set, ParticleType::wall), 16 * 12 * 11 - 10 * 6 * 8);
}

TEST(Filling, ABedThatIsASurfaceLiesOnTheGround) {
  Case scene = empty_scene(2, 0.01);
  add_sand(scene);
  scene.model.sediment = SedimentModel::surface;
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.08));
  add_box(scene, "bed", ShapeRole::sediment, Vec3(0, 0, 0), Vec3(0.2, 0, 0.03)).material = "sand";
  EXPECT_EQ(refusal(scene), "accepted");
  add_box(scene, "slab", ShapeRole::sediment, Vec3(0.1, 0, 0.05), Vec3(0.12, 0, 0.06)).material = "sand";
  EXPECT_THAT(refusal(scene), HasSubstr("hangs over water or a wall"));
  scene.model.sediment = SedimentModel::three_state;
  EXPECT_EQ(refusal(scene), "accepted");
}

TEST(Filling, ClosedTankHasALid) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1)).open.clear();
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::wall), 26 * 16 - 20 * 10);
}

TEST(Filling, FirstParticlesStandHalfASpacingFromFlatWalls) {
  // The tank's corner is off every multiple of the spacing: the lattice has to follow the tank, not the origin.
  const double dp = 0.01;
  const Vec3 corner(0.1234, 0, -0.0567);
  Case scene = empty_scene(2, dp);
  add_tank(scene, corner, corner + Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, corner, corner + Vec3(0.2, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  Vec3 lowest = Vec3::Constant(HUGE_VAL);
  for (std::size_t i = 0; i < set.size(); ++i)
    if (set.type[i] == ParticleType::water) lowest = lowest.cwiseMin(set.position[i]);
  EXPECT_NEAR(lowest.x(), corner.x() + 0.5 * dp, 1e-12);
  EXPECT_NEAR(lowest.z(), corner.z() + 0.5 * dp, 1e-12);
  EXPECT_EQ(lowest.y(), 0);
}

TEST(Filling, IdsRunFromZeroWithoutGapAndFollowSpace) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  double walked = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_EQ(set.id[i], static_cast<std::int64_t>(i));
    if (i > 0) walked += (set.position[i] - set.position[i - 1]).norm();
  }
  // From one particle to the next is a spacing, save for the jump to the next column: the mean stays near two.
  EXPECT_LT(walked / static_cast<double>(set.size()), 2.5 * 0.01);
}

TEST(Filling, NodesOnACommonFaceBelongToOneShape) {
  // Without a container the lattice starts at the domain's corner; both boxes' faces lie on nodes (half spacings).
  Case scene = empty_scene(2, 0.01);
  add_sand(scene);
  scene.domain.from = Vec3(0, 0, 0);
  add_box(scene, "bed", ShapeRole::sediment, Vec3(0.005, 0, 0.005), Vec3(0.105, 0, 0.045));
  add_box(scene, "pool", ShapeRole::water, Vec3(0.005, 0, 0.045), Vec3(0.105, 0, 0.085));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::sediment), 10 * 4);
  EXPECT_EQ(count(set, ParticleType::water), 10 * 4);
}

TEST(Filling, DiscAndSphereConvergeWithTheSpacing) {
  // A lattice fills a ball to within a shell of the spacing: |V_N / V - 1| <= surface * spacing / V, of which counting
  // attains a small share; the error has to shrink below a bound proportional to the spacing.
  for (const int dimension : {2, 3}) {
    for (const double dp : {0.08, 0.04, 0.02}) {
      Case scene = empty_scene(dimension, dp);
      add_ball(scene, "drop", ShapeRole::water, Vec3(0.013, 0, 0.021), 0.5);
      const Summary summary = generate(scene).summary;
      const double error = std::abs(summary.shapes[0].filled / summary.shapes[0].exact - 1);
      EXPECT_LT(error, 0.15 * dimension * dp / 0.5) << dimension << "-D, spacing " << dp;
      EXPECT_EQ(static_cast<double>(summary.shapes[0].particles) * std::pow(dp, dimension), summary.shapes[0].filled);
    }
  }
  Case scene = empty_scene(3, 0.02);
  add_cylinder(scene, "jet", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.3, 0.4, 1.2), 0.2);  // 1.3 m long, oblique
  const Summary summary = generate(scene).summary;
  EXPECT_NEAR(summary.shapes[0].exact, M_PI * 0.04 * 1.3, 1e-12);
  EXPECT_NEAR(summary.shapes[0].filled / summary.shapes[0].exact, 1, 0.02);
}

TEST(Filling, Combinations) {
  const auto water_of = [](ShapeKind kind) {
    Case scene = empty_scene(2, 0.01);
    scene.domain.from = Vec3(0, 0, 0);
    add_box(scene, "left", ShapeRole::none, Vec3(0, 0, 0), Vec3(0.10, 0, 0.10));
    add_box(scene, "right", ShapeRole::none, Vec3(0.06, 0, 0.02), Vec3(0.20, 0, 0.08));
    add_combination(scene, "both", kind, ShapeRole::water, {"left", "right"});
    return count(generate(scene).particles, ParticleType::water);
  };
  const int left = 10 * 10;
  const int right = 14 * 6;
  const int common = 4 * 6;
  EXPECT_EQ(water_of(ShapeKind::combine_union), left + right - common);
  EXPECT_EQ(water_of(ShapeKind::combine_difference), left - common);
  EXPECT_EQ(water_of(ShapeKind::combine_intersection), common);
}

TEST(Filling, LaterShapesTakeThePlaceOfEarlierOnes) {
  Case scene = empty_scene(2, 0.01);
  add_sand(scene);
  scene.domain.from = Vec3(0, 0, 0);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.10, 0, 0.10));
  add_box(scene, "heap", ShapeRole::sediment, Vec3(0.02, 0, 0), Vec3(0.06, 0, 0.03));
  add_box(scene, "bubble", ShapeRole::empty, Vec3(0.05, 0, 0.02), Vec3(0.08, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::sediment), 4 * 3 - 1);  // the bubble takes one node of the heap's corner
  EXPECT_EQ(count(set, ParticleType::water), 100 - 4 * 3 - (3 * 3 - 1));
  ASSERT_EQ(set.state.size(), set.size());
  for (std::size_t i = 0; i < set.size(); ++i)
    EXPECT_EQ(set.state[i] == SedimentState::deposit, set.type[i] == ParticleType::sediment);
}

TEST(Filling, FluidNeverEntersWalls) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "block", ShapeRole::wall, Vec3(0.08, 0, 0), Vec3(0.12, 0, 0.03));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::water), 20 * 5 - 4 * 3);
  EXPECT_THAT(warnings_of(scene),
              ElementsAre(HasSubstr("scene.toml:30: shape \"pool\": 12 of its 100 lattice points lie in walls")));
}

TEST(Filling, SolidsHaveNoParticlesBelowTheirWallsThickness) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.5, 0, 0.5));
  add_box(scene, "block", ShapeRole::wall, Vec3(0.1, 0, 0.1), Vec3(0.3, 0, 0.4));
  scene.domain.from = Vec3(0, 0, 0);
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::wall), 20 * 30 - 14 * 24);  // three layers
  EXPECT_EQ(count(set, ParticleType::water), 50 * 50 - 20 * 30);
}

TEST(Filling, MovingWallsKeepTheirType) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "gate", ShapeRole::moving_wall, Vec3(0.2, 0, 0), Vec3(0.22, 0, 0.1));
  EXPECT_EQ(count(generate(scene).particles, ParticleType::moving_wall), 2 * 10);
}

/// A tank with a step on its floor and a gate from the step up to the rim, water on one side of it.
Case scene_with_gate(int dimension, double spacing) {
  Case scene = empty_scene(dimension, spacing);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.6, 0.2, 0.2));
  add_box(scene, "step", ShapeRole::wall, Vec3(0.2, 0, 0), Vec3(0.6, 0.2, 0.1));
  add_box(scene, "gate", ShapeRole::moving_wall, Vec3(0.2, 0, 0.05), Vec3(0.4, 0.2, 0.2)).motion = "lift";
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0.2, 0.2));
  for (const char* name : {"other", "lift"}) {
    scene.motions.emplace_back().name = name;
    scene.motions.back().kind = MotionKind::gate_lift;
    scene.motions.back().direction = Vec3::UnitZ();
    scene.motions.back().speed = 1;
  }
  return scene;
}

TEST(Filling, WhatStandsStillHasNoHoleWhereAGateHasGone) {
  for (const int dimension : {2, 3}) {
    const double dp = 0.02;
    const Case with_gate = scene_with_gate(dimension, dp);
    Case without = with_gate;
    without.shapes.erase(without.shapes.begin() + 2);
    const auto walls_of = [](const ParticleSet& set) {
      std::map<std::array<long, 3>, Eigen::Vector3f> walls;
      for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec3 n = (set.position[i] / 0.01).array().round();
        if (set.type[i] == ParticleType::wall)
          walls[{static_cast<long>(n.x()), static_cast<long>(n.y()), static_cast<long>(n.z())}] = set.normal[i];
      }
      return walls;
    };
    EXPECT_EQ(walls_of(generate(with_gate).particles), walls_of(generate(without).particles)) << dimension;
  }
}

TEST(Filling, AGateKnowsItsMotionAndYieldsToFixedWalls) {
  const ParticleSet set = generate(scene_with_gate(2, 0.02)).particles;
  std::int64_t gate = 0;
  double lowest = 1;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const bool moves = set.type[i] == ParticleType::moving_wall;
    EXPECT_EQ(set.scalars.at(motion_array)[i], moves ? 2 : 0);
    if (!moves) continue;
    ++gate;
    lowest = std::min(lowest, set.position[i].z());
    // Its skin is all of its own surface, also the foot that stands on the step.
    const Vec3 to_skin = set.position[i] + double(set.scalars.at("WallDistance")[i]) * set.normal[i].cast<double>();
    const Vec3 from_edge = (to_skin - Vec3(0.3, 0, 0.125)).cwiseAbs() - Vec3(0.1, 1, 0.075);
    EXPECT_NEAR(std::max(from_edge.x(), from_edge.z()), 0, 1e-6);
  }
  EXPECT_NEAR(lowest, 0.11, 1e-12) << "on the step, not in it";
  EXPECT_GT(gate, 0);
}

TEST(Filling, FacesOffTheLatticeAreNamed) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.053));
  EXPECT_THAT(warnings_of(scene),
              ElementsAre("scene.toml:20: shape \"pool\": face +z at 5.3 cm lies 3 mm off the lattice (spacing 1 cm "
                          "from 0 m); 5 cm or 6 cm would lie on it"));
  scene.shapes[1].to.z() = 0.05009;  // less than a hundredth of the spacing
  EXPECT_TRUE(warnings_of(scene).empty());
}

TEST(Filling, CylindricalTankIsLinedAllAround) {
  Case scene = empty_scene(2, 0.01);
  add_ball(scene, "pipe", ShapeRole::wall, Vec3(0, 0, 0), 0.1).side = WallSide::outside;
  add_ball(scene, "filling", ShapeRole::water, Vec3(0, 0, 0), 0.1);
  const ParticleSet set = generate(scene).particles;
  // A ring three spacings thick, pi (0.13^2 - 0.1^2) m^2; counting nodes errs by about the root of the 144 on its
  // edges.
  EXPECT_NEAR(static_cast<double>(count(set, ParticleType::wall)), M_PI * 0.0069 / 1e-4, 12);
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::wall) continue;
    EXPECT_NEAR(set.scalars.at("WallDistance")[i], set.position[i].norm() - 0.1, 1e-8);
    EXPECT_LT((set.normal[i].cast<double>() + set.position[i].normalized()).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace thalweg::gencase::test
