// The written case in the real OpenFOAM; skipped, visibly, where that is not installed.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"
#include "foam_reference/all_models.hpp"
#include "foam_reference/reference_run.hpp"
#include "tests/foam_reference/small_scene.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

class OpenFoamTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      require_openfoam();
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  // The value of a row of summary.csv.
  [[nodiscard]] double summary(const std::string& quantity) const {
    const CsvTable table = CsvTable::read(folder_.path() / "summary.csv");
    const auto quantities = table.texts("quantity");
    const auto found = std::ranges::find(quantities, quantity);
    if (found != quantities.end()) {
      return std::stod(table.texts("value")[static_cast<std::size_t>(found - quantities.begin())]);
    }
    ADD_FAILURE() << "no row " << quantity;
    return 0;
  }

  Reference run(const Case& scene, int ranks = 1) {
    return reference_run(make_foam_case(scene, ranks), folder_.path(), [](const std::string&) {});
  }

  TemporaryFolder folder_;
};

// Long enough for the mesh, the filling and a step; not for anything to move.
Case at_start(Case scene) {
  scene.output.end = 0.001;
  scene.compare.times = {0.001};
  return scene;
}

TEST_F(OpenFoamTest, FillsBoxesExactly) {
  run(at_start(still_tank()));
  EXPECT_EQ(summary("cells"), 600);
  EXPECT_NEAR(summary("water_volume_start"), 0.4 * 0.05, 1e-9);
  EXPECT_NEAR(summary("sediment_volume_start"), 0.4 * 0.05, 1e-9);
}

// Cells of 20 mm have centres on the bed's top; whichever way they fall, no cell may be lost between bed and water.
TEST_F(OpenFoamTest, FillsCellsCutInHalvesOnce) {
  Case scene = at_start(still_tank());
  scene.foam.cell = 0.02;
  run(scene);
  EXPECT_NEAR(summary("sediment_volume_start"), 0.4 * 0.06, 1e-9);
  EXPECT_NEAR(summary("water_volume_start"), 0.4 * 0.04, 1e-9);
}

// Water at rest, 0.1 m deep: g z under its surface, and a level that stays.
TEST_F(OpenFoamTest, RecordsGauges) {
  Case scene = water_tank();
  Gauge pressure;
  pressure.name = "floor";
  pressure.kind = GaugeKind::pressure;
  pressure.at = Vec3(0.4, 0, 0.02);  // on the wall
  Gauge level;
  level.name = "pool";
  level.at = Vec3(0.2, 0, 0);
  scene.gauges = {pressure, level};
  scene.output.gauge_interval = 0.01;
  run(scene);
  const CsvTable table = CsvTable::read(folder_.path() / "gauges.csv");
  ASSERT_GE(table.numbers("time", "s").size(), 8U);
  EXPECT_NEAR(table.numbers("floor.pressure", "Pa").back(), 1000 * 9.81 * 0.08,
              10);  // the surface's cell is 10 mm high
  EXPECT_NEAR(table.numbers("pool.level", "m").back(), 0.1, 1e-4);
}

// A disc of 16 cells' diameter takes exactly the cells whose centres it holds.
TEST_F(OpenFoamTest, FillsDiscsAndCombinations) {
  Case scene = at_start(water_tank());
  scene.foam.cell = 0.005;
  scene.shapes[1].role = ShapeRole::none;
  Shape disc;
  disc.name = "disc";
  disc.kind = ShapeKind::sphere;
  disc.center = Vec3(0.2, 0, 0.05);
  disc.radius = 0.04;
  Shape rest;
  rest.name = "rest";
  rest.kind = ShapeKind::combine_difference;
  rest.role = ShapeRole::water;
  rest.of = {"pool", "disc"};
  scene.shapes.push_back(disc);
  scene.shapes.push_back(rest);
  run(scene);
  int cells_in_disc = 0;
  for (int i = 0; i < 16; ++i) {
    for (int k = 0; k < 16; ++k) cells_in_disc += std::hypot(i - 7.5, k - 7.5) <= 8 ? 1 : 0;
  }
  EXPECT_NEAR(summary("water_volume_start"), 0.4 * 0.1 - cells_in_disc * 0.005 * 0.005, 1e-9);
}

TEST_F(OpenFoamTest, TakesSolidWallsOutOfTheMesh) {
  Case scene = at_start(still_tank());
  scene.shapes.push_back(box("sill", ShapeRole::wall, Vec3(0.1, 0, 0), Vec3(0.2, 0, 0.08)));
  run(scene);
  EXPECT_EQ(summary("cells"), 600 - 10 * 8);
  EXPECT_NEAR(summary("sediment_volume_start"), 0.3 * 0.05, 1e-9);
  EXPECT_NEAR(summary("water_volume_start"), 0.4 * 0.05 - 0.1 * 0.03, 1e-9);
  const Profile profile = read_profile(folder_.path() / "profiles" / profile_file_name(0.001));
  EXPECT_NEAR(profile.bed.at(15), 0.08, 1e-6);
  EXPECT_NEAR(profile.free_surface.at(15), 0.1, 1e-6);
}

// At rest by hydrostatics: nothing may move. Profiles stay within a tenth of a cell, which slosh or slump would break.
TEST_F(OpenFoamTest, KeepsLayersAtRest) {
  EXPECT_EQ(run(still_tank()), Reference::computed);
  for (const double time : {0.05, 0.1}) {
    const Profile profile = read_profile(folder_.path() / "profiles" / profile_file_name(time));
    ASSERT_EQ(profile.x.size(), 40U);
    EXPECT_THAT(profile.bed, testing::Each(testing::DoubleNear(0.05, 1e-3)));
    EXPECT_THAT(profile.free_surface, testing::Each(testing::DoubleNear(0.1, 1e-3)));
    EXPECT_TRUE(profile.moving_bed.empty());
  }
  EXPECT_LT(std::abs(summary("water_volume_error")), volume_tolerance);
  EXPECT_LT(std::abs(summary("sediment_volume_error")), volume_tolerance);
  EXPECT_NEAR(summary("tau0"), 36.7875, 1e-6);
}

TEST_F(OpenFoamTest, DoesNotRepeatARunThatIsThere) {
  Case scene = at_start(still_tank());
  scene.output.end = 0.002;
  scene.compare.times = {0.001, 0.002};
  EXPECT_EQ(run(scene), Reference::computed);
  EXPECT_EQ(run(scene), Reference::already_there);

  // A profile that is missing is sampled from the fields, without a run.
  fs::remove(folder_.path() / "profiles" / profile_file_name(0.002));
  EXPECT_EQ(run(scene), Reference::already_there);
  EXPECT_TRUE(fs::exists(folder_.path() / "profiles" / profile_file_name(0.002)));

  scene.foam.cell = 0.02;
  EXPECT_EQ(run(scene), Reference::computed);
  EXPECT_EQ(summary("cells"), 20 * 8);
}

TEST_F(OpenFoamTest, ComputesWaterAlone) {
  run(at_start(water_tank()));
  EXPECT_NEAR(summary("water_volume_start"), 0.4 * 0.1, 1e-9);
  const Profile profile = read_profile(folder_.path() / "profiles" / profile_file_name(0.001));
  EXPECT_TRUE(profile.bed.empty());
}

// A closed box without open faces: the pressure's level is fixed inside.
TEST_F(OpenFoamTest, ComputesAClosedTank) {
  Case scene = at_start(still_tank());
  scene.shapes.front().open.clear();
  run(scene);
  EXPECT_EQ(summary("cells"), 40 * 20);
}

// Water that falls out of an open side is counted as outflow, not as an error.
TEST_F(OpenFoamTest, CountsWaterThatLeavesThroughAnOpenSide) {
  Case scene = water_tank();
  scene.shapes.front().open = {"+x", "+z"};
  scene.compare.times = {0.1};
  run(scene);
  EXPECT_GT(summary("water_outflow"), 1e-4);
  EXPECT_LT(std::abs(summary("water_volume_error")), 5e-3);
}

TEST_F(OpenFoamTest, ComputesTheSameOnTwoRanks) {
  Case scene = still_tank();
  scene.shapes[2].to.x() = 0.2;  // half the water: a dam break, so that something moves
  scene.output.end = 0.02;
  scene.compare.times = {0.02};
  run(scene);
  const Profile serial = read_profile(folder_.path() / "profiles" / profile_file_name(0.02));
  EXPECT_EQ(run(scene, 2), Reference::computed);
  const Profile parallel = read_profile(folder_.path() / "profiles" / profile_file_name(0.02));
  ASSERT_EQ(serial.x.size(), parallel.x.size());
  for (std::size_t i = 0; i < serial.x.size(); ++i) {
    // The solvers' tolerances and the order of sums differ between decompositions: far below a cell.
    EXPECT_NEAR(serial.free_surface[i], parallel.free_surface[i], 1e-4);
    EXPECT_NEAR(serial.bed[i], parallel.bed[i], 1e-4);
  }
}

TEST_F(OpenFoamTest, ComputesInThreeDimensions) {
  Case scene = still_tank();
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.1;
  scene.foam.cell = 0.025;
  scene.output.end = 0.02;
  scene.compare.times = {0.02};
  run(scene);
  EXPECT_EQ(summary("cells"), 16 * 4 * 6);
  EXPECT_NEAR(summary("sediment_volume_start"), 0.4 * 0.1 * 0.05, 1e-9);
  const Profile profile = read_profile(folder_.path() / "profiles" / profile_file_name(0.02));
  EXPECT_THAT(profile.bed, testing::Each(testing::DoubleNear(0.05, 2.5e-3)));
}

// Without the library no other model takes the place of the two that need it; the stock model runs if it is asked for.
TEST_F(OpenFoamTest, RunsNoOtherModelWithoutTheLibrary) {
  setenv("THALWEG_FOAM_LIBRARY", folder_.path().c_str(), 1);  // which holds none
  Case scene = at_start(still_tank());
  try {
    run_models(scene, RunFolder{folder_.path()}, {});
    ADD_FAILURE() << "it ran";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"same-material\" needs libthalwegFoam"));
    EXPECT_LT(std::string(error.what()).size(), 300U);
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "foam"));
  scene.foam.models = {"stock"};
  run_models(scene, RunFolder{folder_.path()}, {});
  unsetenv("THALWEG_FOAM_LIBRARY");
  EXPECT_TRUE(fs::exists(folder_.path() / "foam/stock/summary.csv"));
  EXPECT_TRUE(fs::exists(folder_.path() / "foam/stock-2x/summary.csv"));
}

// A closed box of triangles, in millimetres.
std::string box_surface(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int bits) {
    return fmt::format("vertex {} {} {}\n", (bits & 1) != 0 ? high.x() : low.x(), (bits & 2) != 0 ? high.y() : low.y(),
                       (bits & 4) != 0 ? high.z() : low.z());
  };
  std::string text = "solid box\n";
  constexpr int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& quad : quads) {
    for (const int third : {2, 3}) {
      text += "facet normal 0 0 0\nouter loop\n" + corner(quad[0]) + corner(quad[third - 1]) + corner(quad[third]) +
              "endloop\nendfacet\n";
    }
  }
  return text + "endsolid box\n";
}

// A block of 0.1 m x 0.05 m through all of the height, from a file in millimetres and moved: 4 x 2 columns of cells.
TEST_F(OpenFoamTest, TakesASurfaceMeshOutOfTheMesh) {
  Case scene = still_tank();
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.1;
  scene.foam.cell = 0.025;
  scene.folder = folder_.path();
  folder_.write("block.stl", box_surface(Vec3(0, 25, -50), Vec3(100, 75, 300)));
  Shape block;
  block.name = "block";
  block.kind = ShapeKind::mesh;
  block.role = ShapeRole::wall;
  block.file = "block.stl";
  block.scale = 0.001;
  block.move = {0.1, 0, 0};
  scene.shapes.insert(scene.shapes.begin() + 1, block);
  scene.output.end = 0.01;
  scene.compare.times = {0.01};
  run(scene);
  EXPECT_EQ(summary("cells"), (16 * 4 - 4 * 2) * 6);
  EXPECT_NEAR(summary("sediment_volume_start"), (0.4 * 0.1 - 0.1 * 0.05) * 0.05, 1e-9);
  EXPECT_LT(std::abs(summary("water_volume_error")), 1e-4);
}

}  // namespace
}  // namespace thalweg::foam
