#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "gencase/booleans.hpp"
#include "gencase/mesh_defects.hpp"
#include "gencase/mesh_reader.hpp"
#include "gencase/mesh_repair.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/tessellation.hpp"
#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

namespace fs = std::filesystem;

Triangles moved(Triangles surface, const Vec3& by) {
  for (Vec3& p : surface.points) p += by;
  return surface;
}

double area_of(const Triangles& surface) {
  double area = 0;
  for (const auto& [a, b, c] : surface.corners) {
    const Vec3 u = surface.points[b] - surface.points[a];
    const Vec3 v = surface.points[c] - surface.points[a];
    area +=
        0.5 * Vec3(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()).norm();
  }
  return area;
}

/// Fills a body at three spacings and asks for an error of O(dp) per area of its skin. A node is counted or not by what
/// happens within half a spacing of it, so no error can exceed A dp / 2; counting averages most of that away, and a
/// tenth of the bound is what a wrong side, a missing layer or a leak would break.
void expect_volume(const Triangles& body) {
  const double exact = volume(body);
  ASSERT_GT(exact, 0);
  for (const double dp : {0.08, 0.04, 0.02}) {
    Case scene = empty_scene(3, dp);
    add_mesh(scene, "body", ShapeRole::water, moved(body, Vec3(0.0131, 0.0172, 0.0213)));
    const ShapeSummary filled = generate(scene).summary.shapes[0];
    EXPECT_NEAR(filled.exact, exact, 1e-12 * exact);
    EXPECT_LT(std::abs(filled.filled - exact), 0.05 * area_of(body) * dp) << "spacing " << dp;
  }
}

TEST(MeshVolume, OfASphereConverges) { expect_volume(tessellate_sphere(Vec3::Zero(), 0.5, 1e-4)); }

TEST(MeshVolume, OfATorusConverges) {
  const Triangles ring = torus(0.5, 0.2, 100);
  EXPECT_NEAR(volume(ring), 2 * M_PI * M_PI * 0.5 * 0.04, 0.003 * 0.39);  // 100 sides leave 2 pi^2 / 3 100^-2 twice
  expect_volume(ring);
}

TEST(MeshVolume, OfThreeSolidsCombinedConverges) {
  // A sphere with a bore, on a plinth.
  const Triangles sphere = tessellate_sphere(Vec3::Zero(), 0.5, 1e-3);
  const Triangles bore = revolve(Vec3(-1, 0, 0.1), Vec3::UnitX(), {{0, 0.15}, {2, 0.15}}, 1e-3);
  const Triangles plinth = tessellate_box(Vec3(-0.4, -0.3, -0.7), Vec3(0.4, 0.3, -0.3));
  expect_volume(combine(combine(sphere, bore, Boolean::subtract), plinth, Boolean::unite));
}

TEST(MeshVolume, CombinationsOfNamedShapesAgreeWithPointwiseOnes) {
  // The same difference three ways: meshes cut exactly, lattice points one by one, and shapes with formulas. Facets
  // whose middles lie 2e-5 inside the ball, and half of that on the mean, take 3.14 * 1e-5 m^3 of it: four nodes.
  const auto water_of = [](bool meshes, BooleanMethod method) {
    Case scene = empty_scene(3, 0.02);
    scene.domain.from = Vec3(-0.603, -0.603, -0.603);
    if (meshes)
      add_mesh(scene, "ball", ShapeRole::none, tessellate_sphere(Vec3::Zero(), 0.5, 2e-5));
    else
      add_ball(scene, "ball", ShapeRole::none, Vec3::Zero(), 0.5);
    add_box(scene, "slot", ShapeRole::none, Vec3(-1, -0.101, -0.201), Vec3(1, 0.101, 0.301));
    add_combination(scene, "rest", ShapeKind::combine_difference, ShapeRole::water, {"ball", "slot"}).boolean = method;
    return count(generate(scene).particles, ParticleType::water);
  };
  const auto exact = water_of(true, BooleanMethod::exact);
  EXPECT_GT(exact, 40000);
  EXPECT_EQ(exact, water_of(true, BooleanMethod::voxel));
  EXPECT_NEAR(static_cast<double>(exact), static_cast<double>(water_of(false, BooleanMethod::exact)), 20);
}

TEST(MeshVolume, MassOfABoxIsExact) {
  Case scene = empty_scene(3, 0.05);
  scene.domain.from = Vec3(-1, -1, -1);
  scene.domain.gravity.setZero();
  scene.numerics.maximum_speed = 1;
  add_mesh(scene, "block", ShapeRole::water, tessellate_box(Vec3(0, 0, 0), Vec3(1, 0.5, 0.25)));
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::water), 20 * 10 * 5);
  EXPECT_NEAR(mass_by_type(set)[2], 125, 1e-4);  // kg, summed from single precision
}

TEST(MeshWalls, NormalsOfASphereAreExactToADegree) {
  Case scene = empty_scene(3, 0.05);
  add_box(scene, "pool", ShapeRole::water, Vec3(-1, -1, -1), Vec3(1, 1, 1));
  add_mesh(scene, "ball", ShapeRole::wall, tessellate_sphere(Vec3(0.011, 0.013, 0.017), 0.6, 5e-5));
  const ParticleSet set = generate(scene).particles;
  ASSERT_GT(count(set, ParticleType::wall), 1000);
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::wall) continue;
    const Vec3 arm = set.position[i] - Vec3(0.011, 0.013, 0.017);
    const Vec3 normal = set.normal[i].cast<double>();
    EXPECT_NEAR(normal.norm(), 1, 1e-6);
    // Facets turn by 2 acos(1 - 2.5e-5 / 0.6) = 1 degree in both directions; half of that is the middle's way to a
    // corner.
    EXPECT_GT(normal.dot(arm.normalized()), std::cos(M_PI / 180));
    EXPECT_NEAR(set.scalars.at("WallDistance")[i], 0.6 - arm.norm(), 5.1e-5);
  }
}

/// Nothing is missing from the walls within the reach of a fluid particle's kernel.
void expect_complete_walls(const Case& scene, const Region& solid) {
  const ParticleSet set = generate(scene).particles;
  const double dp = scene.numerics.spacing;
  const auto key = [&](const Vec3& p) {
    return std::array<long, 3>{std::lround(p.x() / dp * 4), std::lround(p.y() / dp * 4), std::lround(p.z() / dp * 4)};
  };
  std::set<std::array<long, 3>> taken;
  for (std::size_t i = 0; i < set.size(); ++i) {
    taken.insert(key(set.position[i]));
    if (set.type[i] != ParticleType::wall) continue;
    EXPECT_NEAR(set.normal[i].norm(), 1, 1e-5);
    EXPECT_GT(set.scalars.at("WallDistance")[i], 0);
  }
  const double support = 2 * scene.smoothing_length();
  const int reach = static_cast<int>(std::ceil(support / dp));
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::water) continue;
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) {
          const Vec3 step = dp * Vec3(x, y, z);
          const Vec3 p = set.position[i] + step;
          if (step.norm() >= support * (1 - 1e-9) || !solid.contains(p)) continue;
          ASSERT_TRUE(taken.contains(key(p))) << p.transpose() << " seen from " << set.position[i].transpose();
        }
  }
}

TEST(MeshWalls, AreCompleteWithinReachOfTheFluid) {
  // A pier from below the floor, with a footing whose edges the floor hides.
  const Triangles shaft = revolve(Vec3(1.01, 1.02, -0.35), Vec3::UnitZ(), {{0, 0.4}, {1.9, 0.4}}, 1e-3);
  const Triangles footing = tessellate_box(Vec3(0.4, 0.45, -0.2), Vec3(1.63, 1.57, 0.23));
  const Triangles pier = combine(shaft, footing, Boolean::unite);
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(2, 2, 1));
  add_mesh(scene, "pier", ShapeRole::wall, pier);
  Shape& water = add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(2, 2, 0.8));
  water.kind = ShapeKind::level;
  water.level = 0.8;
  expect_complete_walls(scene, *make_polyhedron(pier));
}

TEST(MeshWalls, AreCompleteWhereBodiesTouchInAnEdgeOnly) {
  // Two blocks on the floor with one edge in common: their union has no two-manifold skin.
  const Triangles first = tessellate_box(Vec3(0.5, 0.5, 0), Vec3(1, 1, 0.7));
  const Triangles second = tessellate_box(Vec3(1, 1, 0), Vec3(1.6, 1.4, 0.6));
  EXPECT_THROW(combine(first, second, Boolean::unite), NoManifold);
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(2, 2, 1));
  add_mesh(scene, "first", ShapeRole::wall, first);
  add_mesh(scene, "second", ShapeRole::wall, second);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(2, 2, 0.4));
  expect_complete_walls(scene, *make_polyhedron(first));
  expect_complete_walls(scene, *make_polyhedron(second));
}

TEST(MeshWalls, FootOfAPierLooksAtTheRingWhereItMeetsTheFloor) {
  // The pier of surface_test.cpp as a mesh: below the floor the nearest flow is where pier and floor meet.
  Case scene = empty_scene(3, 0.1);
  add_tank(scene, Vec3(0, 0, 0), Vec3(2, 2, 1));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(2, 2, 0.8));
  add_mesh(scene, "pier", ShapeRole::wall, revolve(Vec3(1, 1, -0.5), Vec3::UnitZ(), {{0, 0.4}, {2, 0.4}}, 1e-6));
  const ParticleSet set = generate(scene).particles;
  const std::size_t i = nearest(set, Vec3(1.35, 1.05, -0.05));
  ASSERT_LT((set.position[i] - Vec3(1.35, 1.05, -0.05)).norm(), 1e-9);
  const double inward = 0.4 - std::hypot(0.35, 0.05);
  EXPECT_NEAR(set.scalars.at("WallDistance")[i], std::hypot(inward, 0.05), 1e-5);
  const Vec3 expected = (Vec3(7, 1, 0).normalized() * inward + Vec3(0, 0, 0.05)).normalized();
  EXPECT_LT((set.normal[i].cast<double>() - expected).norm(), 1e-3);
}

TEST(MeshWalls, VesselOfAnyFormIsLinedAllAround) {
  Case scene = empty_scene(3, 0.1);
  add_mesh(scene, "vessel", ShapeRole::wall, tessellate_sphere(Vec3::Zero(), 1, 1e-3)).side = WallSide::outside;
  Shape& water = add_box(scene, "fill", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
  water.kind = ShapeKind::level;
  water.level = 0.2;
  const ParticleSet set = generate(scene).particles;
  // The part of the sphere below z = 0.2: pi h^2 (3 R - h) / 3 with h = 1.2.
  EXPECT_NEAR(static_cast<double>(count(set, ParticleType::water)) * 1e-3, M_PI * 1.44 * 1.8 / 3, 0.05);
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.type[i] != ParticleType::wall) continue;
    EXPECT_NEAR(set.scalars.at("WallDistance")[i], set.position[i].norm() - 1, 1e-3);
    EXPECT_LT(set.position[i].norm(), 1.3);
  }
}

TEST(MeshWalls, PlateHasTwoSides) {
  // An open sheet between two rooms of water: the particles of each half look to their own side.
  Triangles sheet;
  sheet.points = {{0.503, 0, 0}, {0.503, 1, 0}, {0.503, 1, 1}, {0.503, 0, 1}};
  sheet.corners = {{0, 1, 2}, {0, 2, 3}};
  Case scene = empty_scene(3, 0.05);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 1, 1));
  Shape& plate = add_mesh(scene, "plate", ShapeRole::wall, sheet);
  plate.side = WallSide::both;
  plate.thickness = 0.2;
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(1, 1, 0.5));
  const ParticleSet set = generate(scene).particles;
  for (const double x : {0.425, 0.475, 0.525, 0.575}) {
    const std::size_t i = nearest(set, Vec3(x, 0.525, 0.525));
    ASSERT_EQ(set.type[i], ParticleType::wall);
    EXPECT_NEAR(set.normal[i].x(), x < 0.503 ? -1 : 1, 1e-6) << x;
    EXPECT_NEAR(set.scalars.at("WallDistance")[i], 0.1 - std::abs(x - 0.503), 1e-7) << x;
  }
  EXPECT_EQ(set.type[nearest(set, Vec3(0.375, 0.525, 0.225))], ParticleType::water);
  EXPECT_EQ(set.type[nearest(set, Vec3(0.625, 0.525, 0.225))], ParticleType::water);
}

TEST(MeshWalls, CutOfABodyIsASceneOfThePlane) {
  Case scene = empty_scene(2, 0.02);
  add_mesh(scene, "block", ShapeRole::water, tessellate_box(Vec3(0, -0.3, 0), Vec3(1, 0.4, 0.5)));
  scene.domain.from = Vec3(-1, 0, -1);
  const Generated generated = generate(scene);
  EXPECT_EQ(count(generated.particles, ParticleType::water), 50 * 25);
  EXPECT_NEAR(generated.summary.shapes[0].exact, 0.5, 1e-12);
}

TEST(MeshFile, ScaleThenRotationThenMove) {
  Case scene = empty_scene(3, 0.05);
  scene.domain.from = Vec3(-1, -1, -1);
  Shape& block = add_mesh(scene, "block", ShapeRole::water, tessellate_box(Vec3(0, 0, 0), Vec3(1000, 500, 250)));
  block.scale = 1e-3;
  block.rotate = {0, 0, M_PI / 2};  // the long edge turns from x to y
  block.move = {0.5, 0, 0.25};
  const ParticleSet set = generate(scene).particles;
  Vec3 lower = Vec3::Constant(HUGE_VAL);
  Vec3 upper = -lower;
  for (const Vec3& p : set.position) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  EXPECT_EQ(set.size(), 20U * 10U * 5U);
  EXPECT_LT((lower - Vec3(0.025, 0.025, 0.275)).norm(), 1e-9);
  EXPECT_LT((upper - Vec3(0.475, 0.975, 0.475)).norm(), 1e-9);
}

TEST(MeshFile, EveryFormatGivesTheSameBody) {
  const fs::path folder = fs::path(MESHES);
  for (const char* name : {"box.stl", "box_text.stl", "box.obj", "box.off", "box_coloured.off", "box.ply",
                           "box_little_endian.ply", "box_big_endian.ply", "box.vtp"}) {
    const Triangles surface = triangulate(read_mesh(folder / name).soup);
    EXPECT_EQ(surface.points.size(), 8U) << name;
    EXPECT_NEAR(volume(surface), 0.1 * 0.1 * 0.2, 1e-9) << name;
    EXPECT_FALSE(find_defects(surface, SurfaceUse::body).any())
        << name << ": " << find_defects(surface, SurfaceUse::body).text();
  }
}

TEST(MeshRepair, CuresWhatItSays) {
  const Triangles box = tessellate_box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const RepairLimits limits{1e-3, 0, 2};
  Triangles spoiled = box;
  spoiled.corners.pop_back();                               // a hole
  std::swap(spoiled.corners[0][1], spoiled.corners[0][2]);  // a face turned
  spoiled.corners.push_back({3, 3, 1});                     // one without area
  EXPECT_TRUE(find_defects(spoiled, SurfaceUse::body).any());
  const Repaired mended = repair(spoiled, limits);
  EXPECT_THAT(mended.changes, testing::ElementsAre("1 superfluous face dropped", "1 face turned", "1 hole filled"));
  EXPECT_FALSE(find_defects(mended.surface, SurfaceUse::body).any())
      << find_defects(mended.surface, SurfaceUse::body).text();
  EXPECT_NEAR(volume(mended.surface), 1, 1e-12);
}

TEST(MeshRepair, UnitesBodiesThatReachIntoEachOther) {
  Triangles two = tessellate_box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Triangles other = tessellate_box(Vec3(0.5, 0.25, 0.25), Vec3(1.5, 0.75, 0.75));
  for (auto corners : other.corners) {
    for (std::uint32_t& corner : corners) corner += 8;
    two.corners.push_back(corners);
  }
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  EXPECT_EQ(find_defects(two, SurfaceUse::body).intersections, find_defects(two, SurfaceUse::body).between_bodies);
  const Repaired mended = repair(two, {1e-6, 0, 0.1});
  EXPECT_THAT(mended.changes, testing::ElementsAre("overlapping bodies united"));
  EXPECT_NEAR(volume(mended.surface), 1.125, 1e-12);
}

TEST(MeshRepair, WeldsWhatTheLatticeCannotSee) {
  Triangles box = tessellate_box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  // Every face has corners of its own, a tenth of a thousandth off.
  Triangles apart;
  for (const auto& corners : box.corners) {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t corner : corners)
      apart.points.push_back(box.points[corner] + 1e-5 * Vec3(first % 3, first % 5, first % 7));
    apart.corners.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(find_defects(apart, SurfaceUse::body).any());
  const Repaired mended = repair(apart, {1e-3, 0, 0});
  EXPECT_FALSE(find_defects(mended.surface, SurfaceUse::body).any())
      << find_defects(mended.surface, SurfaceUse::body).text();
  EXPECT_NEAR(volume(mended.surface), 1, 1e-3);
}

TEST(MeshDefects, CountsHolesAndTheirLengths) {
  Triangles box = tessellate_box(Vec3(0, 0, 0), Vec3(1, 2, 3));
  box.corners.erase(box.corners.begin() + 2, box.corners.begin() + 4);  // the lid, 1 x 2
  box.corners.erase(box.corners.begin() + 2);                           // half of the side y = 0, 1 x 3
  const MeshDefects defects = find_defects(box, SurfaceUse::body);
  // They share a corner only: 2 + 1 + 2 + 1 around the lid, 1 + 3 + sqrt(10) around half of the side.
  EXPECT_EQ(defects.holes, 2U);
  EXPECT_NEAR(defects.hole_length, 6 + 4 + std::sqrt(10.0), 1e-12);
  EXPECT_NEAR(defects.longest_hole, 4 + std::sqrt(10.0), 1e-12);
  EXPECT_EQ(defects.places.lines.size(), 2U);
}

}  // namespace
}  // namespace thalweg::gencase::test
