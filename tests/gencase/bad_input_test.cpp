#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

using testing::EndsWith;

Case pool_in_tank() {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.05));
  return scene;
}

TEST(BadInput, TheSceneTheseTestsSpoilIsGood) { EXPECT_EQ(refusal(pool_in_tank()), "accepted"); }

TEST(BadInput, ShapeThinnerThanTheSpacing) {
  Case scene = pool_in_tank();
  add_box(scene, "gate", ShapeRole::wall, Vec3(0.1, 0, 0), Vec3(0.104, 0, 0.1));
  EXPECT_EQ(refusal(scene),
            "scene.toml:30: shape \"gate\" measures 4 mm in x, less than the spacing of 1 cm; use a smaller "
            "numerics.spacing or a larger shape");
}

TEST(BadInput, PeriodicDomain) {
  Case scene = pool_in_tank();
  scene.domain.periodic = {"x"};
  EXPECT_EQ(refusal(scene),
            "scene.toml:10: shape \"tank\" walls off x, in which the domain is periodic; add \"-x\" and \"+x\" to its "
            "`open`");
  scene.shapes[0].open = {"-x", "+x", "+z"};
  scene.domain.from.x() = 0;
  scene.domain.to.x() = 0.2;
  EXPECT_EQ(refusal(scene), "accepted");
  scene.domain.to.x() = 0.204;
  EXPECT_EQ(refusal(scene),
            "scene.toml: the domain is periodic in x and 20.4 cm long, no multiple of the spacing of 1 cm; make it 20 "
            "cm or 21 cm long");
}

TEST(BadInput, FlumeThatNothingCanFlowAround) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1)).open = {"-x", "+x", "+z"};
  add_box(scene, "pool", ShapeRole::water, Vec3(0.05, 0, 0), Vec3(0.2, 0, 0.05));
  scene.domain.periodic = {"x"};
  scene.domain.from.x() = 0;
  scene.domain.to.x() = 0.2;
  EXPECT_EQ(refusal(scene), "accepted");
  scene.flow.drive = Drive::slope;
  scene.flow.slope = 0.002;
  EXPECT_EQ(refusal(scene),
            "scene.toml: no water lies at both ends of the period along x, so that nothing can flow around it; let "
            "shapes of water reach both ends, and walls neither");
}

TEST(BadInput, ShapesWithoutParticles) {
  Case scene = pool_in_tank();
  add_box(scene, "pond", ShapeRole::water, Vec3(20, 0, 0), Vec3(21, 0, 0.05));
  EXPECT_EQ(
      refusal(scene),
      "scene.toml:30: shape \"pond\" has 500 of its 500 particles outside of the domain, the first at x = 20.005 m, "
      "z = 5 mm; enlarge [domain] or shrink the shape");

  scene = pool_in_tank();
  add_box(scene, "block", ShapeRole::wall, Vec3(0.05, 0, 0), Vec3(0.15, 0, 0.06));
  add_box(scene, "inclusion", ShapeRole::water, Vec3(0.08, 0, 0.01), Vec3(0.12, 0, 0.02));
  EXPECT_EQ(refusal(scene),
            "scene.toml:40: shape \"inclusion\" gets no particle: it lies inside wall \"block\"; move it, or open the "
            "wall with a shape of role \"empty\" before it");

  scene = pool_in_tank();
  add_box(scene, "drain", ShapeRole::empty, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  EXPECT_EQ(refusal(scene),
            "scene.toml:20: shape \"pool\" gets no particle: later shapes take its place everywhere; put it behind "
            "them in the case, or remove it");

  // A box around the only node at (0.055, 0.055), of which another box takes the middle.
  scene = empty_scene(2, 0.01);
  scene.domain.from = Vec3(0, 0, 0);
  add_box(scene, "corner", ShapeRole::none, Vec3(0.0495, 0, 0.0495), Vec3(0.0605, 0, 0.0605));
  add_box(scene, "middle", ShapeRole::none, Vec3(0.052, 0, 0.052), Vec3(0.058, 0, 0.058));
  add_combination(scene, "frame", ShapeKind::combine_difference, ShapeRole::water, {"corner", "middle"});
  EXPECT_EQ(refusal(scene),
            "scene.toml:30: shape \"frame\" gets no particle: no lattice point lies in it at a spacing of 1 cm; use a "
            "smaller numerics.spacing, or correct the shape");
}

TEST(BadInput, FluidOutsideTheContainer) {
  Case scene = pool_in_tank();
  scene.shapes[0].open.clear();
  scene.shapes[1].to.z() = 0.2;  // through the lid, which is three layers thick, and seven more
  EXPECT_EQ(refusal(scene),
            "scene.toml:20: shape \"pool\" has 140 of its 340 particles outside of every container, the first at x = "
            "5 mm, z = 13.5 cm; shrink the shape, or open that face of the container");
}

TEST(BadInput, WallsOutsideTheDomain) {
  Case scene = pool_in_tank();
  scene.domain.from = Vec3(-0.02, 0, -0.1);
  EXPECT_EQ(refusal(scene),
            "scene.toml:10: shape \"tank\" has 13 of its 138 particles outside of the domain, the first at x = -2.5 "
            "cm, z = -2.5 cm; enlarge [domain] or shrink the shape");
}

TEST(BadInput, MoreThanTheMachinesMemory) {
  Case scene = pool_in_tank();
  // 238 particles of 620 bytes; 1 cm * sqrt(147560 / 40000) = 1.92 cm.
  EXPECT_EQ(refusal(scene, 40000),
            "scene.toml: 238 particles at a spacing of 1 cm need 148 kB of memory and 40 kB are available; raise "
            "numerics.spacing to 2 cm or more");
  scene.numerics.spacing = 1e-6;  // 1e10 particles: refused after a coarse trial, in moments; 1 um * sqrt(6200) = 79 um
  EXPECT_THAT(refusal(scene, 1e9), EndsWith("1 GB are available; raise numerics.spacing to 79 um or more"));
}

TEST(BadInput, LevelWithoutAContainer) {
  Case scene = pool_in_tank();
  scene.shapes.erase(scene.shapes.begin());
  scene.shapes[0].kind = ShapeKind::level;
  scene.shapes[0].level = 0.05;
  EXPECT_EQ(
      refusal(scene),
      "scene.toml:20: shape \"pool\" fills containers, and no wall with side = \"outside\" comes before it; put one "
      "before it");
}

TEST(BadInput, SceneOfAbsurdExtent) {
  Case scene = pool_in_tank();
  scene.numerics.spacing = 1e-9;
  EXPECT_EQ(refusal(scene),
            "scene.toml: the shapes stretch over 2e+08 spacings in x; use a larger numerics.spacing, or check the "
            "shapes' coordinates and units");
}

}  // namespace
}  // namespace thalweg::gencase::test
