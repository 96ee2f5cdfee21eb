#include "foam_reference/mesh_plan.hpp"

#include <vector>

#include "common/error.hpp"
#include "foam_reference/case_files.hpp"
#include "foam_reference/foam_model.hpp"
#include "tests/foam_reference/expect_error.hpp"
#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {
namespace {

std::string plan_refusal(const Case& scene) {
  return message_of<InputError>([&] { make_foam_case(scene, 1); });
}

// Fluid to 0.1 m, half its height of air above: 0.15 m, 15 cells of 10 mm.
TEST(MeshPlan, OpenTopLiesHalfTheFluidsHeightAboveIt) {
  const MeshPlan plan = plan_mesh(still_tank());
  EXPECT_EQ(plan.cells, (std::array<std::int64_t, 3>{40, 1, 15}));
  EXPECT_NEAR(plan.high.z(), 0.15, 1e-12);
  EXPECT_NEAR(plan.cell_volume(), 1e-4, 1e-15);  // 10 mm x 10 mm x 1 m
}

TEST(MeshPlan, TakesTheAirHeightOfTheCaseInWholeCells) {
  Case scene = still_tank();
  scene.foam.open_above = 0.072;
  const MeshPlan plan = plan_mesh(scene);
  EXPECT_EQ(plan.cells[2], 18);  // 0.172 m needs 18 cells
  EXPECT_NEAR(plan.size().z(), 0.01, 1e-12);
}

TEST(MeshPlan, ClosedTopIsTheContainers) {
  Case scene = still_tank();
  scene.shapes.front().open.clear();
  const MeshPlan plan = plan_mesh(scene);
  EXPECT_NEAR(plan.high.z(), 0.2, 1e-12);
  EXPECT_FALSE(plan.open(Face::open));
}

TEST(MeshPlan, FitsCellsToALengthThatIsNoMultiple) {
  Case scene = still_tank();
  scene.foam.cell = 0.015;
  const MeshPlan plan = plan_mesh(scene);
  EXPECT_EQ(plan.cells[0], 27);  // 0.4 / 0.015 = 26.7
  EXPECT_NEAR(plan.size().x() * 27, 0.4, 1e-12);
}

TEST(MeshPlan, CellsAreTwiceTheSpacingUnlessGiven) {
  Case scene = still_tank();
  scene.foam.cell = 0;
  EXPECT_DOUBLE_EQ(cell_size(scene), 0.01);
}

TEST(MeshPlan, PeriodicDirectionsTakeTheDomainsLength) {
  Case scene = still_tank();
  scene.domain.periodic = {"x"};
  const MeshPlan plan = plan_mesh(scene);
  EXPECT_EQ(plan.cells[0], 60);
  EXPECT_EQ(plan.faces[0], Face::periodic);
}

TEST(MeshPlan, ThreeDimensionsFillTheContainersWidth) {
  Case scene = still_tank();
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.1;
  const MeshPlan plan = plan_mesh(scene);
  EXPECT_EQ(plan.cells, (std::array<std::int64_t, 3>{40, 10, 15}));
  EXPECT_NEAR(measure_contents(scene, plan).water_volume, 0.4 * 0.1 * 0.05, 1e-12);
}

TEST(SceneContents, LaterShapesTakeThePlaceOfEarlierOnes) {
  Case scene = still_tank();
  scene.shapes.push_back(box("hole", ShapeRole::empty, Vec3(0.1, 0, 0), Vec3(0.2, 0, 0.1)));
  scene.shapes.push_back(box("block", ShapeRole::wall, Vec3(0.3, 0, 0), Vec3(0.4, 0, 0.03)));
  const SceneContents contents = measure_contents(scene, plan_mesh(scene));
  EXPECT_NEAR(contents.water_volume, 0.3 * 0.05, 1e-12);
  EXPECT_NEAR(contents.sediment_volume, 0.3 * 0.05 - 0.1 * 0.03, 1e-12);
  EXPECT_NEAR(contents.bed_thickness, (0.2 * 0.05 + 0.1 * 0.02) / 0.3, 1e-12);
}

// Sampled at 4 x 4 points a cell: a disc of 8 cells' diameter within 1 %.
TEST(SceneContents, MeasuresDiscsAndCombinations) {
  Case scene = water_tank();
  Shape disc;
  disc.name = "disc";
  disc.kind = ShapeKind::sphere;
  disc.center = Vec3(0.2, 0, 0.05);
  disc.radius = 0.04;
  scene.shapes.push_back(disc);
  scene.shapes[1].role = ShapeRole::none;
  Shape rest;
  rest.name = "rest";
  rest.kind = ShapeKind::combine_difference;
  rest.role = ShapeRole::water;
  rest.of = {"pool", "disc"};
  scene.shapes.push_back(rest);
  const double exact = 0.4 * 0.1 - std::numbers::pi * 0.04 * 0.04;
  EXPECT_NEAR(measure_contents(scene, plan_mesh(scene)).water_volume, exact, 0.01 * std::numbers::pi * 0.04 * 0.04);
}

TEST(Refusal, ABedWhoseTimeRunsFasterThanTheWaters) {
  Case scene = still_tank();
  scene.model.sediment = SedimentModel::surface;
  EXPECT_NE(plan_refusal(scene).find("the bed's time runs faster than the water's"), std::string::npos);
  scene.surface_bed.factor = 1;
  EXPECT_EQ(models_of(scene), std::vector{FoamModel::eroding_bed});
}

TEST(Refusal, NoContainer) {
  Case scene = still_tank();
  scene.shapes.erase(scene.shapes.begin());
  EXPECT_EQ(
      plan_refusal(scene),
      "tank/case.toml: no container; the mesh model needs a wall shape with kind = \"box\" and side = \"outside\"");
}

TEST(Refusal, ContainerThatIsNoBox) {
  Case scene = still_tank();
  scene.shapes.front().kind = ShapeKind::cylinder;
  EXPECT_EQ(
      plan_refusal(scene),
      "tank/case.toml:7: the container \"tank\" is not a box; the mesh model fills boxes only: use kind = \"box\" "
      "and solid wall shapes");
}

TEST(Refusal, TwoContainers) {
  Case scene = still_tank();
  scene.shapes.push_back(scene.shapes.front());
  scene.shapes.back().name = "second";
  scene.shapes.back().line = 31;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml:31: \"second\" is a second container beside \"tank\"; the mesh model takes one wall shape "
            "with side = \"outside\"");
}

TEST(Refusal, MovingWall) {
  Case scene = still_tank();
  scene.shapes.push_back(box("gate", ShapeRole::moving_wall, Vec3(0.2, 0, 0), Vec3(0.21, 0, 0.1)));
  scene.shapes.back().line = 40;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml:40: shape \"gate\" is a moving wall, which the mesh model does not have; run this case "
            "with --no-foam");
}

TEST(Refusal, KindTheMeshModelDoesNotHave) {
  Case scene = water_tank();
  scene.shapes.push_back(box("pier", ShapeRole::wall, Vec3(0.2, 0, 0), Vec3(0.21, 0, 0.1)));
  scene.shapes.back().kind = ShapeKind::mesh;
  scene.shapes.back().line = 40;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml:40: the mesh model takes a mesh as a solid wall in 3-D only, from an STL or OBJ file and "
            "not turned (\"pier\"); run this case with --no-foam");
}

TEST(Refusal, FluidOutsideTheContainer) {
  Case scene = water_tank();
  scene.shapes[1].from.x() = 0.5;
  scene.shapes[1].to.x() = 0.6;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml: water and sediment lie outside the container; move the shapes inside it");
}

TEST(Refusal, NoFluid) {
  Case scene = water_tank();
  scene.shapes.pop_back();
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml: no water and no sediment; give at least one [[shape]] the role \"water\"");
}

TEST(Refusal, CellsLargerThanTheScene) {
  Case scene = still_tank();
  scene.foam.cell = 0.3;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml: cells of 30 cm leave fewer than 2 along x; use a smaller foam.cell (--cell)");
}

TEST(Refusal, MoreCellsThanAMachineHolds) {
  Case scene = still_tank();
  scene.foam.cell = 1e-6;
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml: cells of 1 um make a mesh of 6e+10 cells; use a larger foam.cell (--cell)");
}

TEST(Refusal, GravityThatPointsSideways) {
  Case scene = still_tank();
  scene.domain.gravity = Vec3(9.81, 0, 0);
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml: gravity does not point down; the mesh model integrates columns along z: give "
            "domain.gravity a negative z component that is its largest");
}

TEST(Refusal, UnknownShapeInACombination) {
  Case scene = still_tank();
  Shape both;
  both.name = "both";
  both.kind = ShapeKind::combine_union;
  both.role = ShapeRole::water;
  both.of = {"pool", "lake"};
  both.line = 50;
  scene.shapes.push_back(both);
  EXPECT_EQ(plan_refusal(scene),
            "tank/case.toml:50: shape \"both\" names \"lake\", which does not exist; name a [[shape]] of this case");
}

TEST(WriteInterval, DividesTheEndAndTheTimesToCompare) {
  Case scene = still_tank();
  scene.output.end = 1;
  scene.compare.times = {0.25, 0.75};
  EXPECT_DOUBLE_EQ(write_interval(scene), 0.25);
  scene.output.interval = 0.05;
  EXPECT_DOUBLE_EQ(write_interval(scene), 0.05);
  scene.output.interval = 0.001;  // would be 1000 writes: left out
  EXPECT_DOUBLE_EQ(write_interval(scene), 0.25);
}

TEST(WriteInterval, RefusesTimesWithoutACommonDivisor) {
  Case scene = still_tank();
  scene.output.end = 1;
  scene.compare.times = {0.3337};
  EXPECT_EQ(message_of<InputError>([&] { write_interval(scene); }),
            "tank/case.toml: output.end and compare.times share no interval above 0.002 s; round them so that fields "
            "need not be written more than 500 times");
}

TEST(WriteInterval, RefusesATimeAfterTheEnd) {
  Case scene = still_tank();
  scene.compare.times = {0.2};
  EXPECT_EQ(message_of<InputError>([&] { write_interval(scene); }),
            "tank/case.toml: compare.times holds 0.2 s, after output.end = 0.1 s; take it out or run longer");
}

// A level up to 0.08 m and a layer of 0.03 m fill the container's floor, 0.4 m long.
TEST(Contents, LevelsAndLayersFillTheContainer) {
  Case scene = still_tank();
  scene.shapes[1].kind = ShapeKind::layer;
  scene.shapes[1].thickness = 0.03;
  scene.shapes[2].kind = ShapeKind::level;
  scene.shapes[2].level = 0.08;
  std::swap(scene.shapes[1], scene.shapes[2]);
  const SceneContents contents = make_foam_case(scene, 1).contents;
  EXPECT_NEAR(contents.sediment_volume, 0.4 * 0.03, 1e-9);
  EXPECT_NEAR(contents.water_volume, 0.4 * 0.05, 1e-9);
}

}  // namespace
}  // namespace thalweg::foam
