#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gencase/combinations.hpp"
#include "gencase/nearest_surface.hpp"
#include "gencase/primitives.hpp"
#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

constexpr double anywhere = HUGE_VAL;

void expect_skin(const PointSet& set, const Vec3& from, const Vec3& skin) {
  const auto found = NearestSurface(set, 0.1).find(from, anywhere);
  ASSERT_TRUE(found);
  EXPECT_LT((found->point - skin).norm(), 1e-10) << "from " << from.transpose() << " to " << found->point.transpose();
  EXPECT_NEAR(found->distance, (skin - from).norm(), 1e-10);
  EXPECT_LT((found->direction - (skin - from).normalized()).norm(), 1e-9);
}

TEST(NearestSurface, BoxFromInsideAndOutside) {
  const RegionPointer box = make_box(Vec3(0, 0, 0), Vec3(2, 3, 4), 3);
  expect_skin(*box, Vec3(0.3, 1, 2), Vec3(0, 1, 2));
  expect_skin(*box, Vec3(1, 1.5, 5), Vec3(1, 1.5, 4));
  expect_skin(*box, Vec3(-1, 1, -1), Vec3(0, 1, 0));  // edge
  expect_skin(*box, Vec3(-1, -2, 6), Vec3(0, 0, 4));  // corner
  const RegionPointer flat = make_box(Vec3(0, 0, 0), Vec3(2, 0, 4), 2);
  expect_skin(*flat, Vec3(3, 0, 5), Vec3(2, 0, 4));
}

TEST(NearestSurface, CylinderSideEndAndRim) {
  const RegionPointer cylinder = make_cylinder(Vec3(0, 0, 0), Vec3(0, 0, 2), 1);
  expect_skin(*cylinder, Vec3(0.6, 0.8, 1) * 0.9 + Vec3(0, 0, 0.1), Vec3(0.6, 0.8, 1));
  expect_skin(*cylinder, Vec3(0.1, 0, 1.9), Vec3(0.1, 0, 2));
  expect_skin(*cylinder, Vec3(3, 4, 5), Vec3(0.6, 0.8, 2));
}

TEST(NearestSurface, CreaseOfAUnionIsFoundWhereItsPartsHideEachOther) {
  // Two discs of radius 1, centres 1 apart, meet at (0.5, +-sqrt(3)/2); from the middle both nearest points lie inside
  // the other disc.
  const RegionPointer two = make_union({make_disc(Vec3(0, 0, 0), 1), make_disc(Vec3(1, 0, 0), 1)});
  expect_skin(*two, Vec3(0.5, 0, 0.1), Vec3(0.5, 0, std::sqrt(0.75)));
  // A block standing on a floor: inside the corner that both hide, the nearest flow is where they meet.
  const RegionPointer step =
      make_union({make_box(Vec3(-9, 0, -1), Vec3(9, 0, 0), 2), make_box(Vec3(0, 0, -1), Vec3(9, 0, 1), 2)});
  expect_skin(*step, Vec3(0.1, 0, -0.2), Vec3(0, 0, 0));
}

TEST(NearestSurface, DifferenceTurnsItsSecondPartInsideOut) {
  const RegionPointer ring = make_difference({make_disc(Vec3(0, 0, 0), 2), make_disc(Vec3(0, 0, 0), 1)});
  expect_skin(*ring, Vec3(1.2, 0, 0), Vec3(1, 0, 0));
  expect_skin(*ring, Vec3(0, 0, 1.7), Vec3(0, 0, 2));
}

TEST(NearestSurface, AgreesWithSamplingTheSkin) {
  // A sphere with a box cut out and a cylinder added: nearest points against 400 000 points sampled on its skin.
  const RegionPointer body =
      make_union({make_difference({make_sphere(Vec3(0, 0, 0), 1), make_box(Vec3(0.2, 0.1, -2), Vec3(2, 2, 2), 3)}),
                  make_cylinder(Vec3(-0.5, -0.5, -1.5), Vec3(-0.5, -0.5, 1.5), 0.3)});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-1.6, 1.6);
  std::vector<const Surface*> surfaces;
  body->append_surfaces(surfaces);
  std::vector<Vec3> skin;
  while (skin.size() < 400000) {
    const Vec3 p(side(random), side(random), side(random));
    for (const Surface* surface : surfaces) {
      const Vec3 n = surface->gradient(p);
      const Vec3 q = p - surface->signed_distance(p) * n;
      if (body->contains(q + 1e-6 * n) != body->contains(q - 1e-6 * n)) skin.push_back(q);
    }
  }
  const NearestSurface nearest(*body, 0.05);
  for (int sample = 0; sample < 200; ++sample) {
    const Vec3 from(side(random), side(random), side(random));
    double sampled = HUGE_VAL;
    for (const Vec3& q : skin) sampled = std::min(sampled, (q - from).norm());
    const auto found = nearest.find(from, anywhere);
    ASSERT_TRUE(found);
    EXPECT_LE(found->distance, sampled + 1e-9) << from.transpose();
    EXPECT_GE(found->distance, sampled - 0.03) << from.transpose();  // the samples are about 0.02 apart
  }
}

TEST(NearestSurface, NothingWithinReach) {
  const RegionPointer sphere = make_sphere(Vec3(0, 0, 0), 1);
  EXPECT_FALSE(NearestSurface(*sphere, 0.1).find(Vec3(0, 0, 0.2), 0.5));
  EXPECT_TRUE(NearestSurface(*sphere, 0.1).find(Vec3(0, 0, 0.2), 0.81));
}

/// Checks one wall particle's normal and distance.
void expect_wall(const ParticleSet& set, const Vec3& at, const Vec3& normal, double distance) {
  const std::size_t i = nearest(set, at);
  ASSERT_LT((set.position[i] - at).norm(), 1e-9);
  ASSERT_EQ(set.type[i], ParticleType::wall);
  EXPECT_LT((set.normal[i].cast<double>() - normal.normalized()).norm(), 1e-6) << at.transpose();
  EXPECT_NEAR(set.scalars.at("WallDistance")[i], distance, 1e-8) << at.transpose();
}

TEST(WallNormals, OfATankIncludingItsCorners) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.05));
  const ParticleSet set = generate(scene).particles;
  expect_wall(set, Vec3(0.055, 0, -0.015), Vec3(0, 0, 1), 0.015);
  expect_wall(set, Vec3(-0.025, 0, 0.095), Vec3(1, 0, 0), 0.025);  // at the open top: still sideways
  expect_wall(set, Vec3(0.205, 0, 0.005), Vec3(-1, 0, 0), 0.005);
  expect_wall(set, Vec3(-0.005, 0, -0.005), Vec3(1, 0, 1), 0.005 * std::sqrt(2));
  expect_wall(set, Vec3(0.225, 0, -0.005), Vec3(-5, 0, 1), std::hypot(0.025, 0.005));
  for (std::size_t i = 0; i < set.size(); ++i) {
    const bool wall = set.type[i] == ParticleType::wall;
    EXPECT_NEAR(set.normal[i].norm(), wall ? 1 : 0, 1e-6);
    EXPECT_EQ(set.scalars.at("WallDistance")[i] > 0, wall);
  }
}

TEST(WallNormals, OfATankCorner3d) {
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 1, 1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(1, 1, 0.5));
  const ParticleSet set = generate(scene).particles;
  expect_wall(set, Vec3(-0.05, 1.15, -0.25), Vec3(1, -3, 5), std::sqrt(0.05 * 0.05 + 0.15 * 0.15 + 0.25 * 0.25));
  expect_wall(set, Vec3(-0.05, 0.55, -0.05), Vec3(1, 0, 1), 0.05 * std::sqrt(2));
}

TEST(WallNormals, OfAPierSunkIntoTheFloor) {
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(2, 2, 1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(2, 2, 0.8));
  add_cylinder(scene, "pier", ShapeRole::wall, Vec3(1, 1, -0.5), Vec3(1, 1, 1.5), 0.4);
  const ParticleSet set = generate(scene).particles;
  expect_wall(set, Vec3(1.25, 1.05, 0.45), Vec3(5, 1, 0), 0.4 - std::hypot(0.25, 0.05));
  // Below the floor the pier is hidden: the nearest flow is the circle where pier and floor meet.
  const double inward = 0.4 - std::hypot(0.35, 0.05);
  const Vec3 radial = Vec3(7, 1, 0).normalized();
  expect_wall(set, Vec3(1.35, 1.05, -0.05), radial * inward + Vec3(0, 0, 0.05), std::hypot(inward, 0.05));
  // Nothing stands where no fluid within the kernel's support can see it.
  for (std::size_t i = 0; i < set.size(); ++i) EXPECT_GT(set.position[i].z(), -0.3);
  const std::size_t axis = nearest(set, Vec3(1.05, 1.05, 0.45));
  EXPECT_GT((set.position[axis] - Vec3(1, 1, 0.45)).norm(), 0.1 - 1e-9);  // the core is empty
}

TEST(WallNormals, OfADiscPointOutwardFromItsCentre) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.5, 0, 0.5));
  add_ball(scene, "pipe", ShapeRole::wall, Vec3(0.25, 0, 0.25), 0.1);
  const ParticleSet set = generate(scene).particles;
  int walls = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Vec3 arm = set.position[i] - Vec3(0.25, 0, 0.25);
    if (set.type[i] != ParticleType::wall) {
      EXPECT_GT(arm.norm(), 0.1 - 1e-7);
      continue;
    }
    ++walls;
    EXPECT_LT((set.normal[i].cast<double>() - arm.normalized()).norm(), 1e-6);
    EXPECT_NEAR(set.scalars.at("WallDistance")[i], 0.1 - arm.norm(), 1e-8);
  }
  EXPECT_NEAR(walls * 1e-4, M_PI * (0.01 - 0.0049), 0.05 * M_PI * 0.0051);
}

}  // namespace
}  // namespace thalweg::gencase::test
