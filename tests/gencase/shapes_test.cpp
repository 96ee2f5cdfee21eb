#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include "gencase/closure.hpp"
#include "gencase/polygon.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/primitives.hpp"
#include "gencase/tessellation.hpp"
#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

bool in(const Spans& spans, double at) {
  return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return at >= s.low && at <= s.high; });
}

/// Cutting a region along any axis says the same as asking for its points.
void expect_cuts_agree(const Region& region, std::vector<int> axes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(-1.3, 1.3);
  for (int sample = 0; sample < 3000; ++sample) {
    Vec3 p(side(random), side(random), side(random));
    if (axes.size() == 2) p.y() = 0;
    for (const int axis : axes) {
      Line line;
      line.origin = p;
      line.axis = axis;
      EXPECT_EQ(in(region.cut(line), p[axis]), region.contains(p)) << p.transpose() << " along " << axis;
    }
  }
}

TEST(Cuts, AgreeWithMembership) {
  expect_cuts_agree(*make_box(Vec3(-1, -0.5, -0.2), Vec3(0.3, 0.4, 1), 3), {0, 1, 2});
  expect_cuts_agree(*make_cylinder(Vec3(-0.5, -0.4, -0.8), Vec3(0.6, 0.5, 0.7), 0.5), {0, 1, 2});
  expect_cuts_agree(*make_cylinder(Vec3(0.1, 0.2, -0.8), Vec3(0.1, 0.2, 0.7), 0.5), {0, 1, 2});
  expect_cuts_agree(*make_cone(Vec3(-0.5, -0.4, -0.8), Vec3(0.6, 0.5, 0.7), 0.8, 0.1), {0, 1, 2});
  expect_cuts_agree(*make_cone(Vec3(0, 0, -1), Vec3(0, 0, 1), 0, 1.2), {0, 1, 2});
  expect_cuts_agree(*make_sphere(Vec3(0.1, 0.2, -0.1), 0.9), {0, 1, 2});
  expect_cuts_agree(*make_disc(Vec3(0.1, 0, -0.1), 0.9), {0, 2});
  expect_cuts_agree(*make_polygon(edges_of({{-1, -1}, {1, -0.8}, {0.2, 0}, {0.9, 1}, {-0.7, 0.6}})), {0, 2});
  expect_cuts_agree(*make_polyhedron(torus(0.7, 0.3, 30)), {0, 1, 2});
  expect_cuts_agree(*make_container_wall(Vec3(-0.8, -0.8, -0.8), Vec3(0.7, 0.7, 0.7), {}, 0.3, 3), {0, 1, 2});
}

TEST(Cuts, LinesThroughEdgesAndCornersOfAMeshAreDecidedOnce) {
  // Columns exactly through the corners, edges and diagonals of a box's faces.
  const RegionPointer box = make_polyhedron(tessellate_box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  for (const double x : {0.25, 0.5, 0.75})
    for (const double y : {0.25, 0.5, 0.75}) {
      Line line;
      line.origin = Vec3(x, y, 0);
      const Spans spans = box->cut(line);
      ASSERT_EQ(spans.size(), 1U);
      EXPECT_EQ(spans[0].low, 0);
      EXPECT_EQ(spans[0].high, 1);
    }
  int corners = 0;  // of four boxes around a common edge, a line along that edge lies in one
  for (const double x : {-1.0, 0.0})
    for (const double y : {-1.0, 0.0}) {
      Line line;
      corners += !make_polyhedron(tessellate_box(Vec3(x, y, 0), Vec3(x + 1, y + 1, 1)))->cut(line).empty();
    }
  EXPECT_EQ(corners, 1);
}

TEST(Spans, Algebra) {
  const Spans a{{0, 2}, {4, 6}};
  const Spans b{{1, 5}};
  ASSERT_EQ(unite(a, b).size(), 1U);
  EXPECT_EQ(unite(a, b)[0].high, 6);
  ASSERT_EQ(intersect(a, b).size(), 2U);
  EXPECT_EQ(intersect(a, b)[1].low, 4);
  const Spans rest = subtract(a, b);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_LT(rest[0].high, 1);  // what is taken away keeps its ends
  EXPECT_GT(rest[1].low, 5);
}

TEST(Cone, VolumeAndNormals) {
  Case scene = empty_scene(3, 0.02);
  Shape& cone = add_cylinder(scene, "heap", ShapeRole::water, Vec3(0.003, 0.004, 0), Vec3(0.003, 0.004, 0.6), 0.5);
  cone.kind = ShapeKind::cone;
  cone.end_radius = 0.1;
  const ShapeSummary heap = generate(scene).summary.shapes[0];
  EXPECT_NEAR(heap.exact, M_PI / 3 * 0.6 * (0.25 + 0.05 + 0.01), 1e-12);
  EXPECT_NEAR(heap.filled / heap.exact, 1, 0.01);

  scene = empty_scene(3, 0.05);
  add_box(scene, "pool", ShapeRole::water, Vec3(-1, -1, -1), Vec3(1, 1, 1));
  Shape& peak = add_cylinder(scene, "peak", ShapeRole::wall, Vec3(0, 0, -0.8), Vec3(0, 0, 0.8), 0.8);
  peak.kind = ShapeKind::cone;  // half the slope: the side's normal is (2, 1) / sqrt(5)
  const ParticleSet set = generate(scene).particles;
  const std::size_t i = nearest(set, Vec3(0.275, 0.025, 0.125));
  const Vec3 radial = Vec3(0.275, 0.025, 0).normalized();
  EXPECT_LT((set.normal[i].cast<double>() - (2 * radial + Vec3(0, 0, 1)).normalized()).norm(), 1e-6);
  EXPECT_NEAR(set.scalars.at("WallDistance")[i], (0.8 - 0.925 / 2 - std::hypot(0.275, 0.025)) * 2 / std::sqrt(5.0),
              1e-7);
}

TEST(Cone, InThePlaneIsItsCut) {
  Case scene = empty_scene(2, 0.01);
  Shape& cone = add_cylinder(scene, "heap", ShapeRole::water, Vec3(0.5, 0, 0), Vec3(0.5, 0, 0.4), 0.3);
  cone.kind = ShapeKind::cone;
  EXPECT_NEAR(generate(scene).summary.shapes[0].exact, 0.3 * 0.4, 1e-12);
}

TEST(Prism, InThePlaneAndInSpace) {
  const std::vector<Eigen::Vector2d> ramp{{0, 0}, {0, 0.5}, {1, 0}};  // clockwise; either way round is right
  Case scene = empty_scene(2, 0.01);
  Shape& flat = add_box(scene, "ramp", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
  flat.kind = ShapeKind::prism;
  flat.polygon = ramp;
  ShapeSummary filled = generate(scene).summary.shapes[0];
  EXPECT_NEAR(filled.exact, 0.25, 1e-12);
  EXPECT_NEAR(filled.filled, 0.25, 0.002);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    scene = empty_scene(3, 0.02);
    Shape& solid = add_box(scene, "ramp", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
    solid.kind = ShapeKind::prism;
    solid.polygon = ramp;
    solid.axis = axis;
    solid.extent = {-0.2, 0.4};
    filled = generate(scene).summary.shapes[0];
    EXPECT_NEAR(filled.exact, 0.15, 1e-12);
    EXPECT_NEAR(filled.filled, 0.15, 0.003);
  }
}

TEST(Prism, WallInThePlaneHasExactNormals) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 0, 0.5));
  Shape& ramp = add_box(scene, "ramp", ShapeRole::wall, Vec3::Zero(), Vec3::Zero());
  ramp.kind = ShapeKind::prism;
  ramp.polygon = {{0.4, -0.1}, {1.1, -0.1}, {1.1, 0.25}};
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(1, 0, 0.2));
  const ParticleSet set = generate(scene).particles;
  const Vec3 normal = Vec3(-1, 0, 2).normalized();
  const std::size_t i = nearest(set, Vec3(0.805, 0, 0.095));
  ASSERT_EQ(set.type[i], ParticleType::wall);
  EXPECT_LT((set.normal[i].cast<double>() - normal).norm(), 1e-6);
  EXPECT_NEAR(set.scalars.at("WallDistance")[i], -normal.dot(set.position[i] - Vec3(0.6, 0, 0)), 1e-8);
}

/// A file of this process, gone with it.
class Survey : public testing::Test {
 protected:
  Survey() : file_(std::filesystem::temp_directory_path() / ("survey_" + std::to_string(getpid()) + ".csv")) {}
  ~Survey() override { std::filesystem::remove(file_); }
  Shape& add_survey(Case& scene, ShapeRole role, const std::string& text) {
    std::ofstream(file_) << text;
    scene.folder = file_.parent_path();
    Shape& shape = add_box(scene, "ground", role, Vec3::Zero(), Vec3::Zero());
    shape.kind = ShapeKind::bathymetry;
    shape.file = file_.filename();
    return shape;
  }
  std::filesystem::path file_;
};

TEST_F(Survey, BedUnderAMeasuredSurface) {
  // z = 0.1 + 0.1 x over a flume of 1 m x 0.4 m; the survey is wider than the flume.
  Case scene = empty_scene(3, 0.02);
  add_sand(scene);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 0.4, 0.5));
  add_survey(scene, ShapeRole::sediment, "x [m],y [m],z [m]\n-1,-1,0\n2,-1,0.3\n2,2,0.3\n-1,2,0\n").base = -1;
  const ParticleSet set = generate(scene).particles;
  EXPECT_NEAR(static_cast<double>(count(set, ParticleType::sediment)) * 8e-6, 0.4 * 0.15, 0.001);
  for (std::size_t i = 0; i < set.size(); ++i)
    EXPECT_TRUE(set.type[i] != ParticleType::sediment || set.position[i].z() < 0.1 + 0.1 * set.position[i].x() + 1e-6);
}

TEST_F(Survey, GroundAsAWallAndALayerOnIt) {
  // A floor that rises by steps of the section; the bed follows it with equal thickness.
  Case scene = empty_scene(2, 0.01);
  add_sand(scene);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 0, 0.5));
  add_survey(scene, ShapeRole::wall, "x [m],z [m]\n0.503,0.1\n-1,0.1\n0.604,0.2\n2,0.2\n").base = -1;
  Shape& bed = add_box(scene, "bed", ShapeRole::sediment, Vec3::Zero(), Vec3::Zero());
  bed.kind = ShapeKind::layer;
  bed.thickness = 0.05;
  const ParticleSet set = generate(scene).particles;
  EXPECT_EQ(count(set, ParticleType::sediment), 100 * 5);
  EXPECT_EQ(set.type[nearest(set, Vec3(0.205, 0, 0.145))], ParticleType::sediment);
  EXPECT_EQ(set.type[nearest(set, Vec3(0.805, 0, 0.245))], ParticleType::sediment);
  EXPECT_EQ(set.type[nearest(set, Vec3(0.805, 0, 0.195))], ParticleType::wall);
}

TEST(Level, FillsTheContainerAroundWhatStandsInIt) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(1, 0, 0.5));
  add_ball(scene, "pipe", ShapeRole::wall, Vec3(0.5, 0, 0.15), 0.1);
  Shape& water = add_box(scene, "water", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
  water.kind = ShapeKind::level;
  water.level = 0.3;
  const ParticleSet set = generate(scene).particles;
  EXPECT_NEAR(static_cast<double>(count(set, ParticleType::water)) * 1e-4, 0.3 - M_PI * 0.01, 0.001);
}

std::string closure_of(const Case& scene) {
  std::string text;
  GenerateOptions options;
  options.notes.say = [&](const std::string& line) {
    if (line.starts_with("closure")) text = line;
  };
  options.notes.warn = [&](const std::string& line) { text = line; };
  generate(scene, options);
  return text;
}

TEST(Closure, HoleInTheFloorIsFoundAndDrawn) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.5, 0, 0.3));
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.5, 0, 0.1));
  EXPECT_EQ(closure_of(scene), "closure: no leak, fluid at rest stays inside");

  add_box(scene, "drain", ShapeRole::empty, Vec3(0.2, 0, -0.05), Vec3(0.22, 0, 0));
  const std::vector<PlacedShape> shapes = place_shapes(scene);
  const FlowRoom room = flow_room(shapes);
  Progress progress;
  const Filling filling = claim_nodes(shapes, make_lattice(scene, shapes, 0.01), progress);
  const auto leak = find_leak(scene, shapes, room, filling);
  ASSERT_TRUE(leak);
  EXPECT_TRUE(leak->out_of_rooms);
  EXPECT_NEAR(leak->path.front().z(), 0.005, 1e-9);  // from the lowest water over the drain
  EXPECT_GT(leak->path.front().x(), 0.19);
  EXPECT_LT(leak->path.front().x(), 0.23);
  for (std::size_t i = 1; i < leak->path.size(); ++i)
    EXPECT_NEAR((leak->path[i] - leak->path[i - 1]).norm(), 0.01, 1e-9);
}

TEST(Closure, FluidBetweenWallsWithoutAFloorRunsOut) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "left", ShapeRole::wall, Vec3(0, 0, 0), Vec3(0.05, 0, 0.3));
  add_box(scene, "right", ShapeRole::wall, Vec3(0.25, 0, 0), Vec3(0.3, 0, 0.3));
  add_box(scene, "pool", ShapeRole::water, Vec3(0.05, 0, 0), Vec3(0.25, 0, 0.1));
  EXPECT_NE(closure_of(scene).find("fluid at rest can leave the domain"), std::string::npos) << closure_of(scene);
  add_box(scene, "floor", ShapeRole::wall, Vec3(0, 0, -0.05), Vec3(0.3, 0, 0));
  EXPECT_EQ(closure_of(scene), "closure: no leak, fluid at rest stays inside");
}

TEST(Closure, CountsAWallThatMovesAsLongAsItStands) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "floor", ShapeRole::wall, Vec3(-0.1, 0, -0.05), Vec3(0.5, 0, 0));
  add_box(scene, "back", ShapeRole::wall, Vec3(-0.05, 0, 0), Vec3(0, 0, 0.2));
  add_box(scene, "gate", ShapeRole::moving_wall, Vec3(0.3, 0, 0), Vec3(0.35, 0, 0.2)).motion = "lift";
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.3, 0, 0.1));
  scene.motions.emplace_back().name = "lift";
  EXPECT_EQ(closure_of(scene), "closure: no leak, fluid at rest stays inside");
  scene.shapes.erase(scene.shapes.begin() + 2);
  EXPECT_NE(closure_of(scene), "closure: no leak, fluid at rest stays inside");
}

TEST(Closure, OpenFacesAndPeriodicDirectionsAreNoLeak) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.5, 0, 0.3)).open = {"+z", "+x", "-x"};
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.5, 0, 0.1));
  EXPECT_EQ(closure_of(scene), "closure: no leak, fluid at rest stays inside");
}

TEST(Relaxation, EvensOutTheFluidBesideACurvedWall) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.5, 0, 0.5));
  add_ball(scene, "pipe", ShapeRole::wall, Vec3(0.2513, 0, 0.2227), 0.1);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.5, 0, 0.5));
  const ParticleSet lattice = generate(scene).particles;
  scene.gencase.relaxation = 200;
  std::string said;
  GenerateOptions options;
  options.notes.say = [&](const std::string& line) { said += line; };
  const ParticleSet relaxed = generate(scene, options).particles;
  double before = 0;
  double after = 0;
  ASSERT_NE(said.find("unevenness "), std::string::npos) << said;
  ASSERT_EQ(std::sscanf(said.c_str() + said.find("unevenness "), "unevenness %lf before, %lf after", &before, &after),
            2);
  EXPECT_LT(after, 0.8 * before) << said;
  ASSERT_EQ(relaxed.size(), lattice.size());
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const double moved = (relaxed.position[i] - lattice.position[i]).norm();
    EXPECT_LE(moved, 0.01 + 1e-12);
    if (relaxed.type[i] != ParticleType::water) {
      EXPECT_EQ(moved, 0);
      continue;
    }
    const double from_pipe = (relaxed.position[i] - Vec3(0.2513, 0, 0.2227)).norm() - 0.1;
    EXPECT_GT(from_pipe, 0.00499);                  // half a spacing; on the lattice some stand at a tenth of that
    EXPECT_TRUE(from_pipe < 0.07 || moved < 1e-9);  // the lattice, also beside the tank's flat walls, is even
    const double way = relaxed.position[i].z() - lattice.position[i].z();
    EXPECT_NEAR(relaxed.pressure[i] - lattice.pressure[i], -9810 * way, 0.01);
  }
}

/// A ball, or a pier through the floor, in a tank full of water.
Case round_wall_in_tank(ShapeKind kind, const Vec3& center, double radius) {
  Case scene = empty_scene(3, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(0.22, 0.22, 0.22));
  if (kind == ShapeKind::sphere) {
    add_ball(scene, "ball", ShapeRole::wall, center, radius);
  } else {
    add_cylinder(scene, "pier", ShapeRole::wall, Vec3(center.x(), center.y(), -0.05), Vec3(center.x(), center.y(), 0.3),
                 radius);
  }
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.22, 0.22, 0.22));
  return scene;
}

TEST(Relaxation, EvensOutTheFluidBesideABallAndAPierInSpace) {
  const Vec3 center(0.1113, 0.1087, 0.1027);
  const double radius = 0.04;
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::cylinder}) {
    Case scene = round_wall_in_tank(kind, center, radius);
    const ParticleSet lattice = generate(scene).particles;
    scene.gencase.relaxation = 60;
    std::string said;
    GenerateOptions options;
    options.notes.say = [&](const std::string& line) { said += line + "\n"; };
    const ParticleSet relaxed = generate(scene, options).particles;
    int sweeps = 0;
    double before = 0;
    double after = 0;
    ASSERT_NE(said.find("relaxation: "), std::string::npos) << said;
    ASSERT_EQ(std::sscanf(said.c_str() + said.find("relaxation: "),
                          "relaxation: %d sweeps over %*d particles beside walls; unevenness %lf before, %lf after",
                          &sweeps, &before, &after),
              3)
        << said;
    EXPECT_LE(sweeps, 60);
    EXPECT_LT(after, 0.5 * before) << said;
    ASSERT_EQ(relaxed.size(), lattice.size());
    int stepped_back = 0;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const double moved = (relaxed.position[i] - lattice.position[i]).norm();
      EXPECT_LE(moved, 0.01 + 1e-12);
      if (relaxed.type[i] != ParticleType::water) {
        EXPECT_EQ(moved, 0);
        continue;
      }
      const auto from_wall = [&](Vec3 arm) {
        if (kind == ShapeKind::cylinder) arm.z() = 0;
        return arm.norm() - radius;
      };
      EXPECT_GT(from_wall(relaxed.position[i] - center), 0.00499);
      if (from_wall(lattice.position[i] - center) < 0.0049) ++stepped_back;
      const double way = relaxed.position[i].z() - lattice.position[i].z();
      EXPECT_NEAR(relaxed.pressure[i] - lattice.pressure[i], -9810 * way, 0.01);
    }
    EXPECT_GT(stepped_back, 20) << "on the lattice some stand nearer than half a spacing";
  }
}

TEST(Anchor, LatticeFollowsTheCase) {
  Case scene = empty_scene(2, 0.01);
  add_box(scene, "pool", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.1, 0, 0.1));
  scene.gencase.anchor = LatticeAnchor::point;
  scene.gencase.anchor_point = Vec3(0.003, 0, 0.004);
  const Vec3 p = generate(scene).particles.position.front();
  EXPECT_NEAR(std::remainder(p.x() - 0.008, 0.01), 0, 1e-9);
  EXPECT_NEAR(std::remainder(p.z() - 0.009, 0.01), 0, 1e-9);
}

}  // namespace
}  // namespace thalweg::gencase::test
