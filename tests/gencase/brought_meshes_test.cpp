#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "gencase/booleans.hpp"
#include "gencase/mesh_bodies.hpp"
#include "gencase/mesh_defects.hpp"
#include "gencase/mesh_reader.hpp"
#include "gencase/mesh_repair.hpp"
#include "gencase/mesh_sheets.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/tessellation.hpp"
#include "tests/gencase/scene.hpp"

// Meshes as programs write them and people bring them.
namespace thalweg::gencase::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Triangles box = tessellate_box(Vec3(0, 0, 0), Vec3(0.4, 0.3, 0.2));

Triangles together(const std::vector<Triangles>& bodies) {
  Triangles all;
  for (const Triangles& body : bodies) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), body.points.begin(), body.points.end());
    for (const auto& [a, b, c] : body.corners) all.corners.push_back({a + first, b + first, c + first});
  }
  return all;
}

/// One number for each place, as a reader of a file gives them.
Triangles welded(const Triangles& surface) {
  PolygonSoup soup;
  soup.points = surface.points;
  for (const auto& [a, b, c] : surface.corners) soup.polygons.push_back({a, b, c});
  return triangulate(soup);
}

std::string text_stl(const std::string& first, const std::string& last) {
  std::string text = first + "\n";
  for (const auto& corners : box.corners) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t corner : corners) {
      const Vec3& p = box.points[corner];
      text += "  vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + "\t" + std::to_string(p.z()) + "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + last;
}

std::string capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string binary_stl(const std::string& name) {
  std::string bytes(84 + 50 * box.corners.size(), '\0');
  std::copy(name.begin(), name.end(), bytes.begin());
  const auto count = static_cast<std::uint32_t>(box.corners.size());
  std::memcpy(bytes.data() + 80, &count, sizeof(count));
  for (std::size_t face = 0; face < box.corners.size(); ++face)
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3f p = box.points[box.corners[face][k]].cast<float>();
      std::memcpy(bytes.data() + 84 + 50 * face + 12 * (k + 1), p.data(), 12);
    }
  return bytes;
}

double volume_of(const std::string& bytes, MeshFormat format) {
  std::istringstream from(bytes);
  const Triangles surface = triangulate(read_mesh(from, format).soup);
  EXPECT_EQ(surface.points.size(), 8U);
  EXPECT_FALSE(find_defects(surface, SurfaceUse::body).any());
  return volume(surface);
}

std::string refused(const std::string& bytes, MeshFormat format) {
  try {
    std::istringstream from(bytes);
    read_mesh(from, format);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BroughtStl, OfAnyHandIsTheSameBox) {
  const std::string plain = text_stl("solid box", "endsolid box\n");
  for (const std::string& text :
       {plain, capitals(plain), "\xEF\xBB\xBF" + plain, text_stl("Solid box", "EndSolid"),
        text_stl("solid\tbox", "endsolid\tbox\r\n"), text_stl("solid a vertex facet b", "end solid"),
        text_stl("solid box", ""), text_stl("  solid", "endsolid")})
    EXPECT_NEAR(volume_of(text, MeshFormat::stl), 0.024, 1e-9) << text.substr(0, 20);
  for (const char* name : {"", "solid", "solid of one facet and a vertex", "SOLID"})
    EXPECT_NEAR(volume_of(binary_stl(name), MeshFormat::stl), 0.024, 1e-8) << name;
}

TEST(BroughtStl, IsRefusedWithItsLine) {
  std::string text = text_stl("solid", "endsolid");
  EXPECT_THAT(refused(text.substr(0, text.size() - 40), MeshFormat::stl), HasSubstr("it is cut off; export it again"));
  const std::size_t number = text.find("0.4");
  text.replace(number, 3, "0,4");
  EXPECT_THAT(refused(text, MeshFormat::stl), HasSubstr("\"0,400000\" is no number"));
  EXPECT_EQ(refused("solid\nfacet\nvertex 0 0 0\nendfacet\nendsolid", MeshFormat::stl),
            "line 4: a facet of 1 corners ends here; export it again");
}

std::string obj(const std::string& begin, const std::string& face) {
  std::string text = begin;
  for (const Vec3& p : box.points)
    text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " \\\n " + std::to_string(p.z()) + "\n";
  for (const auto& [a, b, c] : box.corners)
    text +=
        face + std::to_string(a + 1) + "/1/1 " + std::to_string(b + 1) + "//2 \\\r\n" + std::to_string(c + 1) + "\n";
  return text;
}

TEST(BroughtObj, OfAnyHandIsTheSameBox) {
  for (const char* begin : {"", "\xEF\xBB\xBF", "# x\n\tmtllib a\nvn 0 0 1\n"})
    for (const char* face : {"f ", "f\t", "  f "})
      EXPECT_NEAR(volume_of(obj(begin, face), MeshFormat::obj), 0.024, 1e-9) << begin << face;
}

TEST(BroughtObj, LeavesOutEdgesWithARemark) {
  std::istringstream from(obj("", "f ") + "l 1 2\nl 2 3\np 1\n");
  const MeshFile file = read_mesh(from, MeshFormat::obj);
  EXPECT_EQ(file.soup.polygons.size(), 12U);
  EXPECT_THAT(file.remarks, ElementsAre("2 lines and 1 points beside its faces are left out"));
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", MeshFormat::obj),
            "line 4: the face names the point \"-4\", which is none; export it again");
}

TEST(Bodies, AreTurnedOneByOne) {
  const Triangles far = tessellate_box(Vec3(1, 0, 0), Vec3(2, 1, 1));
  const Triangles farther = tessellate_box(Vec3(3, 0, 0), Vec3(4, 1, 1));
  const Judged judged = judge_bodies(together({box, far, turned(farther)}));
  EXPECT_NEAR(volume(judged.surface), 2.024, 1e-12);
  EXPECT_THAT(judged.changes, ElementsAre("has 1 of its 3 bodies inside out; turned"));
  EXPECT_THAT(judge_bodies(turned(box)).changes, ElementsAre("is inside out and was turned"));
}

TEST(Bodies, InsideOthersAreCavitiesOrTheSameSolid) {
  const Triangles inner = tessellate_box(Vec3(0.1, 0.1, 0.05), Vec3(0.3, 0.2, 0.15));  // 0.002 m^3
  const Judged solid = judge_bodies(together({box, inner}));
  EXPECT_NEAR(volume(solid.surface), 0.024, 1e-12);
  ASSERT_EQ(solid.changes.size(), 1U);
  EXPECT_THAT(solid.changes[0], HasSubstr("has 1 of its 2 bodies wholly inside another"));
  const Judged hollow = judge_bodies(together({box, turned(inner)}));
  EXPECT_NEAR(volume(hollow.surface), 0.022, 1e-12);
  EXPECT_TRUE(hollow.changes.empty());
  // The whole of it inside out: both turn.
  EXPECT_NEAR(volume(judge_bodies(turned(together({box, turned(inner)}))).surface), 0.022, 1e-12);
  // A pebble in the cavity is solid, whichever way it looks.
  const Triangles pebble = tessellate_box(Vec3(0.15, 0.12, 0.08), Vec3(0.25, 0.18, 0.12));  // 0.00024 m^3
  for (const Triangles& given : {pebble, turned(pebble)})
    EXPECT_NEAR(volume(judge_bodies(together({box, turned(inner), given})).surface), 0.02224, 1e-12);
  const Repaired repaired = repair(together({box, inner}), {1e-6, 0, 0.01});
  EXPECT_NEAR(volume(repaired.surface), 0.024, 1e-12);  // with a repair it is read the same way
}

TEST(Bodies, ThatTouchAreNoDefect) {
  const std::vector<std::pair<Vec3, Vec3>> beside{{Vec3(0.4, 0.3, 0), Vec3(0.8, 0.6, 0.2)},    // in an edge
                                                  {Vec3(0.4, 0.3, 0.2), Vec3(0.8, 0.6, 0.4)},  // in a corner
                                                  {Vec3(0.4, 0, 0), Vec3(0.8, 0.3, 0.2)}};     // in a face
  for (const auto& [from, to] : beside) {
    Triangles two = welded(together({box, tessellate_box(from, to)}));
    cancel_back_to_back(two);
    part_sheets(two);
    EXPECT_FALSE(find_defects(two, SurfaceUse::body).any()) << find_defects(two, SurfaceUse::body).text();
    EXPECT_NEAR(volume(judge_bodies(two).surface), 0.048, 1e-12);
    const Repaired mended = repair(two, {1e-6, 0, 0.01});
    EXPECT_FALSE(find_defects(mended.surface, SurfaceUse::body).any());
    EXPECT_NEAR(volume(mended.surface), 0.048, 1e-12);
  }
}

TEST(Repair, ClosesSlitsByTheirWidth) {
  for (const double width : {5e-6, 5e-5, 5e-4}) {
    Triangles left = tessellate_box(Vec3(0, 0, 0), Vec3(0.2, 0.3, 0.2));
    Triangles right = tessellate_box(Vec3(0.2 + width, 0, 0), Vec3(0.4, 0.3, 0.2));
    left.corners.erase(left.corners.begin() + 10, left.corners.end());           // the face +x
    right.corners.erase(right.corners.begin() + 8, right.corners.begin() + 10);  // the face -x
    EXPECT_TRUE(find_defects(together({left, right}), SurfaceUse::body).any());
    const Repaired mended = repair(together({left, right}), {1e-5, 1e-3, 0.04});
    EXPECT_FALSE(find_defects(mended.surface, SurfaceUse::body).any()) << width;
    EXPECT_NEAR(volume(mended.surface), 0.024, 0.5 * 0.06 * width + 1e-12);
  }
}

TEST(Repair, CutsEdgesAtPointsThatLieOnThem) {
  // The faces of the top meet in a point in the middle of an edge that the side y = 0 does not have.
  Triangles spoiled = box;
  const auto middle = static_cast<std::uint32_t>(spoiled.points.size());
  spoiled.points.emplace_back(0.2, 0, 0.2);
  spoiled.corners[2] = {4, middle, 7};
  spoiled.corners[3] = {4, 7, 6};
  spoiled.corners.push_back({middle, 5, 7});
  EXPECT_TRUE(find_defects(spoiled, SurfaceUse::body).any());
  const Repaired mended = repair(spoiled, {1e-5, 1e-3, 0.04});
  EXPECT_FALSE(find_defects(mended.surface, SurfaceUse::body).any());
  EXPECT_NEAR(volume(mended.surface), 0.024, 1e-12);
}

TEST(Repair, DropsLooseFacesButNoPartOfABody) {
  Triangles stray;
  for (const double size : {0.01, 0.1}) {
    stray.points = {Vec3(1, 0, 0), Vec3(1 + size, 0, 0), Vec3(1, size, 0)};
    stray.corners = {{0, 1, 2}};
    const Repaired mended = repair(together({box, stray}), {1e-5, 1e-3, 0.04});
    EXPECT_THAT(mended.changes, ElementsAre("1 loose face dropped"));
    EXPECT_NEAR(volume(mended.surface), 0.024, 1e-12);
  }
  Triangles open = box;
  open.corners.resize(10);
  EXPECT_TRUE(find_defects(repair(open, {1e-5, 1e-3, 0.04}).surface, SurfaceUse::body).any());
}

Case tank_with(double offset) {
  Case scene = empty_scene(3, 0.02);
  const Vec3 by = Vec3::Constant(offset);
  scene.domain.from = Vec3(-0.2, -0.2, -0.2) + by;
  scene.domain.to = Vec3(0.62, 0.52, 0.42) + by;
  add_tank(scene, Vec3(-0.12, -0.12, -0.12) + by, Vec3(0.54, 0.44, 0.34) + by);
  return scene;
}

void fill_to(Case& scene, double level) {
  Shape& pool = add_box(scene, "pool", ShapeRole::water, Vec3::Zero(), Vec3::Zero());
  pool.kind = ShapeKind::level;
  pool.level = level;
}

TEST(HangingMesh, HasTheParticlesOfTheBoxThatItIs) {
  // In an open tank, touching no wall. At the first offset a cut that rounded the tank's open side lost the body.
  for (const double offset : {0.0, 0.13, 0.37}) {
    const Vec3 by = Vec3::Constant(offset);
    std::vector<std::int64_t> walls;
    std::vector<std::int64_t> water;
    for (const bool mesh : {true, false}) {
      Case scene = tank_with(offset);
      Triangles body = box;
      for (Vec3& p : body.points) p += by;
      if (mesh)
        add_mesh(scene, "body", ShapeRole::wall, body);
      else
        add_box(scene, "body", ShapeRole::wall, by, Vec3(0.4, 0.3, 0.2) + by);
      fill_to(scene, 0.24 + offset);
      const Generated filled = generate(scene);
      walls.push_back(filled.summary.shapes[1].particles);
      water.push_back(filled.summary.shapes[2].particles);
    }
    EXPECT_EQ(walls[0], walls[1]);
    EXPECT_EQ(water[0], water[1]);
    EXPECT_GT(walls[0], 2000);
  }
}

Triangles plate(const std::vector<Vec3>& corners) {
  Triangles sheet;
  sheet.points = corners;
  sheet.corners = {{0, 1, 2}, {0, 2, 3}};
  return sheet;
}

TEST(Plates, ThatMeetOrCrossAreTheirUnion) {
  const Triangles along = plate({Vec3(0, 0.1, 0), Vec3(0.4, 0.1, 0), Vec3(0.4, 0.1, 0.2), Vec3(0, 0.1, 0.2)});
  const Triangles cross = plate({Vec3(0.2, -0.05, 0), Vec3(0.2, 0.25, 0), Vec3(0.2, 0.25, 0.2), Vec3(0.2, -0.05, 0.2)});
  const Triangles foot = plate({Vec3(0.2, 0.1, 0), Vec3(0.2, 0.3, 0), Vec3(0.2, 0.3, 0.2), Vec3(0.2, 0.1, 0.2)});
  for (const Triangles& other : {cross, foot}) {
    std::vector<std::int64_t> counts;
    for (const bool one_file : {true, false}) {
      Case scene = tank_with(0);
      if (one_file) add_mesh(scene, "plate", ShapeRole::wall, welded(together({along, other}))).side = WallSide::both;
      if (!one_file) {
        add_mesh(scene, "first", ShapeRole::wall, along).side = WallSide::both;
        add_mesh(scene, "second", ShapeRole::wall, other).side = WallSide::both;
      }
      fill_to(scene, 0.24);
      counts.push_back(count(generate(scene).particles, ParticleType::wall));
    }
    EXPECT_EQ(counts[0], counts[1]);
  }
}

TEST(Slice, OfABodyThatBeginsAtThePlane) {
  for (const double from : {0.0, -0.1}) {
    Case scene = empty_scene(2, 0.01);
    add_mesh(scene, "body", ShapeRole::water, tessellate_box(Vec3(0, from, 0), Vec3(0.4, from + 0.1, 0.2)));
    EXPECT_EQ(generate(scene).particles.size(), 800U);
  }
}

TEST(ThickTank, IsNoContainerAndALevelFillsItsHollow) {
  const Triangles outer = tessellate_box(Vec3(-0.03, -0.03, -0.03), Vec3(0.43, 0.33, 0.23));
  const Triangles tank = together({outer, turned(tessellate_box(Vec3(0, 0, 0), Vec3(0.4, 0.3, 0.2)))});
  Case scene = empty_scene(3, 0.01);
  add_mesh(scene, "tank", ShapeRole::wall, tank).side = WallSide::outside;
  fill_to(scene, 0.1);
  EXPECT_THAT(refusal(scene), HasSubstr("is a tank with a wall of its own: with side = \"outside\" water fills its "
                                        "material"));
  EXPECT_LE(refusal(scene).size(), 300U);
  scene.shapes[0].side = WallSide::inside;
  EXPECT_EQ(count(generate(scene).particles, ParticleType::water), 40 * 30 * 10);
}

/// A tank of 0.4 x 0.3 x 0.2 m inside with walls of 3 cm, open at the top, without what `cut` takes away.
Triangles open_tank(const Triangles& cut = {}) {
  const Triangles outer = tessellate_box(Vec3(-0.03, -0.03, -0.03), Vec3(0.43, 0.33, 0.2));
  const Triangles tank = combine(outer, tessellate_box(Vec3(0, 0, 0), Vec3(0.4, 0.3, 0.3)), Boolean::subtract);
  return cut.corners.empty() ? tank : combine(tank, cut, Boolean::subtract);
}

Case filled_tank(const Triangles& tank, double level) {
  Case scene = empty_scene(3, 0.01);
  add_mesh(scene, "tank", ShapeRole::wall, tank);
  fill_to(scene, level);
  return scene;
}

TEST(ThickTank, OpenAtTheTopIsFilledUpToItsRim) {
  EXPECT_EQ(count(generate(filled_tank(open_tank(), 0.1)).particles, ParticleType::water), 40 * 30 * 10);
  EXPECT_EQ(count(generate(filled_tank(open_tank(), 0.2)).particles, ParticleType::water), 40 * 30 * 20);
  const std::string over = refusal(filled_tank(open_tank(), 0.21));
  EXPECT_THAT(over,
              HasSubstr("finds no hollow that the walls before it hold up to 21 cm: what it fills would run out"));
  EXPECT_LE(over.size(), 300U);
}

TEST(ThickTank, RunsOutOfAHoleAboveTheLevelOnly) {
  const Triangles pierced = open_tank(tessellate_box(Vec3(0.35, 0.1, 0.1), Vec3(0.5, 0.2, 0.15)));
  EXPECT_EQ(count(generate(filled_tank(pierced, 0.1)).particles, ParticleType::water), 40 * 30 * 10);
  EXPECT_THAT(refusal(filled_tank(pierced, 0.12)), HasSubstr("would run out"));
}

TEST(ThickTank, IsFilledWhereverItStandsAndAroundWhatStandsInIt) {
  Triangles tank = open_tank();
  for (Vec3& p : tank.points) p += Vec3(0.0031, -0.0017, 0.0043);
  EXPECT_EQ(count(generate(filled_tank(tank, 0.1)).particles, ParticleType::water), 40 * 30 * 10);
  Case scene = empty_scene(3, 0.01);
  add_mesh(scene, "tank", ShapeRole::wall, open_tank());
  add_box(scene, "pier", ShapeRole::wall, Vec3(0.1, 0.1, 0), Vec3(0.2, 0.2, 0.2));
  fill_to(scene, 0.1);
  EXPECT_EQ(count(generate(scene).particles, ParticleType::water), (40 * 30 - 10 * 10) * 10);
}

TEST(ThickTank, OfBoxesHoldsALevelAndALayer) {
  Case scene = empty_scene(2, 0.01);
  add_sand(scene);
  add_box(scene, "floor", ShapeRole::wall, Vec3(-0.05, 0, -0.05), Vec3(0.45, 0, 0));
  add_box(scene, "left", ShapeRole::wall, Vec3(-0.05, 0, 0), Vec3(0, 0, 0.2));
  add_box(scene, "right", ShapeRole::wall, Vec3(0.4, 0, 0), Vec3(0.45, 0, 0.2));
  fill_to(scene, 0.1);
  Shape& bed = add_box(scene, "bed", ShapeRole::sediment, Vec3::Zero(), Vec3::Zero());
  bed.kind = ShapeKind::layer;
  bed.thickness = 0.05;
  const ParticleSet filled = generate(scene).particles;
  EXPECT_EQ(count(filled, ParticleType::sediment), 40 * 5);
  EXPECT_EQ(count(filled, ParticleType::water), 40 * 5);
}

}  // namespace
}  // namespace thalweg::gencase::test
