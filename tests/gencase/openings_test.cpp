#include "gencase/openings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/gencase/scene.hpp"

// Inlets and outlets in a filled scene: zones are cleared, and what stands in their way is refused.
namespace thalweg::gencase::test {
namespace {

/// A floor under water, an inlet at x = 0 and an outlet at x = 0.4 m; their zones are 3.45 + 2 spacings long.
Case channel() {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "floor", ShapeRole::wall, Vec3(-0.2, 0, -0.05), Vec3(0.6, 0, 0));
  add_box(scene, "water", ShapeRole::water, Vec3(-0.1, 0, 0), Vec3(0.45, 0, 0.1));
  Inlet& inlet = scene.inlets.emplace_back();
  inlet.name = "west";
  inlet.at = Vec3(0, 0, 0.1);
  inlet.direction = Vec3::UnitX();
  inlet.height = 0.2;
  inlet.velocity = 0.4;
  Outlet& outlet = scene.outlets.emplace_back();
  outlet.name = "east";
  outlet.at = Vec3(0.4, 0, 0.1);
  outlet.direction = Vec3::UnitX();
  outlet.height = 0.2;
  outlet.kind = OutletKind::level;
  outlet.level = 0.1;
  return scene;
}

TEST(Openings, ClearTheZonesOfInlets) {
  const Generated generated = generate(channel());
  // All of 10 columns upstream of the plane and nothing else: 45 columns of 10 nodes are left.
  EXPECT_EQ(count(generated.particles, ParticleType::water), 450);
  for (std::size_t i = 0; i < generated.particles.size(); ++i) {
    if (generated.particles.type[i] != ParticleType::water) continue;
    EXPECT_GT(generated.particles.position[i].x(), 0);
  }
}

// Above and below a beam the water starts with one discharge together, not with all of it each.
TEST(Openings, WaterAboveAndBelowABodyShareTheDischargeAtTheStart) {
  Case scene = channel();
  add_box(scene, "beam", ShapeRole::wall, Vec3(0.1, 0, 0.02), Vec3(0.2, 0, 0.05));
  std::swap(scene.shapes[1], scene.shapes[2]);
  scene.flow.start = FlowStart::log_law;
  scene.flow.discharge = 0.04;
  scene.water.viscosity = 1e-3;
  const Generated generated = generate(scene);
  double along = 0;
  double through = 0;  // of the column over x = 0.155 m, past the beam, and of one before it
  for (std::size_t i = 0; i < generated.particles.size(); ++i) {
    if (generated.particles.type[i] != ParticleType::water) continue;
    const double x = generated.particles.position[i].x();
    const double carried = double(generated.particles.velocity[i].x()) * 0.01;
    if (std::abs(x - 0.155) < 0.004) through += carried;
    if (std::abs(x - 0.055) < 0.004) along += carried;
  }
  EXPECT_NEAR(along, 0.04, 0.03 * 0.04);
  EXPECT_NEAR(through, 0.04, 0.06 * 0.04);
}

TEST(Openings, RaiseTheSoundSpeedOfFastWater) {
  Case scene = channel();
  scene.inlets[0].velocity = 5;
  EXPECT_DOUBLE_EQ(generate(scene).resolved.numerics.maximum_speed, 5);
}

TEST(Openings, RefuseAWallInTheWay) {
  Case scene = channel();
  // Three columns of three; the lowest row lies on the rim, which a floor may touch.
  add_box(scene, "sill", ShapeRole::wall, Vec3(-0.03, 0, 0), Vec3(0, 0, 0.03));
  EXPECT_EQ(refusal(scene).substr(0, 76),
            "scene.toml: inlet.west: 6 wall particles stand in its opening or its zone of");
}

// A case that fills its zone at one spacing fills it at half of it, too, where the zone is shorter.
TEST(Openings, TakeOutWaterThatEndsBehindATailWater) {
  for (const double to : {0.45, 0.5, 0.6}) {
    Case scene = channel();
    scene.shapes[1].to.x() = to;
    EXPECT_EQ(count(generate(scene).particles, ParticleType::water), 450) << to;
  }
}

TEST(Openings, RefuseWaterThatGoesOnBehindATailWater) {
  Case scene = channel();
  for (const std::size_t shape : {0U, 1U}) scene.shapes[shape].to.x() = 0.8;
  EXPECT_EQ(refusal(scene),
            "scene.toml: outlet.east: water stands behind its zone of 5.45 cm, for one at x = 62.5 cm, z = 5 mm; let "
            "the shape end there");
}

TEST(Openings, LeaveOtherWaterBehindAnOutletAlone) {
  Case scene = channel();
  scene.shapes[0].to.x() = 0.8;
  add_box(scene, "pool", ShapeRole::water, Vec3(0.65, 0, 0), Vec3(0.75, 0, 0.1));
  EXPECT_EQ(count(generate(scene).particles, ParticleType::water), 450 + 100);
}

TEST(Openings, RefuseABedThatGoesOnPastAPlane) {
  Case scene = channel();
  add_sand(scene);
  scene.model.sediment = SedimentModel::viscoplastic;
  scene.shapes[0].to.z() = -0.03;
  add_box(scene, "bed", ShapeRole::sediment, Vec3(0, 0, -0.03), Vec3(0.5, 0, 0));
  EXPECT_EQ(refusal(scene),
            "scene.toml: outlet.east: sediment lies past its plane, the first at x = 40.5 cm, z = -2.5 cm; let a wall "
            "take its place from there on, as no water presses on a bed where the zone ends");
  scene.shapes.back().to.x() = 0.4;
  EXPECT_EQ(refusal(scene), "accepted");
}

TEST(Openings, RefuseZonesThatOverlap) {
  Case scene = channel();
  scene.outlets[0].at.x() = -0.02;
  EXPECT_EQ(refusal(scene), "scene.toml: the zones of inlet.west and outlet.east overlap; move them apart");
}

}  // namespace
}  // namespace thalweg::gencase::test
