// Currents in the mesh model: the block, the patches, the conditions at them, and what is refused. No OpenFOAM runs.
#include "foam_reference/current.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "common/error.hpp"
#include "foam_reference/current_block.hpp"
#include "foam_reference/foam_model.hpp"
#include "foam_reference/initial_fields.hpp"
#include "foam_reference/opening_conditions.hpp"
#include "foam_reference/solid_faces.hpp"
#include "foam_reference/velocity_sampler.hpp"
#include "physics/water/log_profile.hpp"
#include "tests/foam_reference/current_scene.hpp"
#include "tests/foam_reference/expect_error.hpp"

namespace thalweg::foam {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string refusal(const Case& scene, FoamModel model = FoamModel::stock) {
  const std::string message = message_of<InputError>([&] { make_foam_case(scene, 1, model); });
  EXPECT_LE(message.size(), 300U) << message;
  return message;
}

TEST(BlockOfACurrent, ReachesALayerOfCellsBelowWhatTheWaterCanReach) {
  const MeshPlan plan = plan_mesh(flume());
  EXPECT_EQ(plan.faces[0], Face::periodic);
  EXPECT_EQ(plan.faces[5], Face::open);
  EXPECT_NEAR(plan.low.z(), -0.01, 1e-12);
  EXPECT_NEAR(plan.high.z(), 0.15, 1e-12);  // half the water's height of air
  EXPECT_EQ(plan.cells, (std::array<std::int64_t, 3>{20, 1, 16}));
  EXPECT_EQ(plan.flow_points.size(), 1U);
}

TEST(BlockOfACurrent, EndsAtThePlanesOfInletAndOutlet) {
  const MeshPlan plan = plan_mesh(channel());
  EXPECT_NEAR(plan.low.x(), 0, 1e-12);
  EXPECT_NEAR(plan.high.x(), 0.6, 1e-12);
  EXPECT_NEAR(plan.low.z(), -0.02, 1e-12);
  EXPECT_NEAR(plan.high.z(), 0.3, 1e-12);  // the domain's end, below half of 0.2 m over the openings
  EXPECT_NEAR(measure_contents(channel(), plan).water_volume, 0.06, 1e-12);
  EXPECT_NEAR(measure_contents(channel(), plan).water_area, 0.6, 1e-12);
}

// The room under the floor, which no water reaches, goes with the walls.
TEST(BlockOfACurrent, KeepsOnlyCellsThatTheFlowReaches) {
  const CaseFiles files = mesh_files(make_foam_case(channel(), 1));
  EXPECT_THAT(files.at("system/topoSetDict.solids"),
              HasSubstr("source regionToCell; set flow; insidePoints ( (0.01 0 0.01)"));
  EXPECT_THAT(files.at("system/topoSetDict.openings"),
              HasSubstr("name inlet0; type faceSet; action new; source boxToFace"));
  EXPECT_THAT(files.at("system/createPatchDict"), HasSubstr("name outlet0; patchInfo { type patch; }"));
  EXPECT_THAT(scripts(make_foam_case(channel(), 1)).at("Allrun"), HasSubstr("createPatch -overwrite"));
}

// A gate stands over the slot of the inlet, outside the block: without the wall water ran out through it.
TEST(SolidFaces, CloseTheBlockWhereAGateStandsBehindItsPlane) {
  const FoamCase foam_case = make_foam_case(sluice(), 1);
  const std::vector<SolidFaces> faces = solid_faces(foam_case);
  ASSERT_EQ(faces.size(), 3U);  // the floor behind both planes, and the gate
  EXPECT_NEAR(faces[1].bounds.low.z(), 0.04, 1e-12);
  EXPECT_NEAR(faces[1].bounds.high.z(), foam_case.plan.high.z(), 1e-12);
  EXPECT_NEAR(faces[1].bounds.high.x(), 2e-4, 1e-12);
  EXPECT_EQ(faces[2].bounds.low.y(), -0.5);
  const CaseFiles files = mesh_files(foam_case);
  EXPECT_THAT(files.at("system/topoSetDict.openings"),
              HasSubstr("name beside_solids; type faceSet; action subtract; source faceToFace; set inlet0"));
  EXPECT_THAT(files.at("system/createPatchDict"),
              HasSubstr("name solids; patchInfo { type wall; } constructFrom set; set beside_solids;"));
}

TEST(SolidFaces, GoToThePatchOfTheirRoughness) {
  Case scene = sluice();
  scene.shapes.back().roughness = 2e-3;
  const std::vector<SolidFaces> faces = solid_faces(make_foam_case(scene, 1));
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[0].solids, 0U);
  EXPECT_EQ(faces[1].solids, 1U);
}

// A sphere behind a plane in space: strips of different heights.
TEST(SolidFaces, FollowARoundWallInSpace) {
  Case scene = sluice();
  scene.info.dimension = 3;
  scene.domain.to.y() = 0.4;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.4;
  Shape& gate = scene.shapes.back();
  gate = Shape();
  gate.name = "ball";
  gate.role = ShapeRole::wall;
  gate.kind = ShapeKind::sphere;
  gate.center = Vec3(-0.01, 0.2, 0.1);
  gate.radius = 0.05;
  scene.inlets[0].at.y() = 0.2;
  scene.inlets[0].width = 0.4;
  scene.outlets[0].at.y() = 0.2;
  scene.outlets[0].width = 0.4;
  const FoamCase foam_case = make_foam_case(scene, 1);
  double area = 0;
  for (const SolidFaces& faces : solid_faces(foam_case)) {
    if (faces.bounds.low.z() < 0 || faces.bounds.high.x() > 0.1) continue;
    area += (faces.bounds.high.y() - faces.bounds.low.y()) * (faces.bounds.high.z() - faces.bounds.low.z());
  }
  EXPECT_NEAR(area, 16 * 0.02 * 0.02, 1e-12);  // the faces whose middles lie within 50 mm of (0.2 m, 0.1 m)
}

TEST(Model, OfACurrentIsInterFoamAndTheErodingBed) {
  Case scene = still_tank();
  EXPECT_EQ(application_of(channel(), FoamModel::stock), "interFoam");
  EXPECT_FALSE(needs_library(channel(), FoamModel::stock));
  EXPECT_TRUE(needs_library(flume(), FoamModel::stock));  // the drive
  scene.inlets = channel().inlets;
  EXPECT_EQ(models_of(scene), (std::vector{FoamModel::eroding_bed}));
}

TEST(DriveFile, HasTheSlopeAsAnAcceleration) {
  const std::string text = option_files(make_foam_case(flume(), 1)).at("constant/fvOptions");
  EXPECT_THAT(text, HasSubstr("type            drivenWater;"));
  EXPECT_THAT(text, HasSubstr("acceleration    0.0193257;"));  // 9.81 x 0.00197
  EXPECT_FALSE(option_files(make_foam_case(channel(), 1)).contains("constant/fvOptions"));
}

TEST(DriveFile, ControlsADischargeOverTheAreaOfTheWater) {
  Case scene = flume();
  scene.flow.drive = Drive::discharge;
  scene.flow.discharge = 0.05;
  const std::string text = option_files(make_foam_case(scene, 1)).at("constant/fvOptions");
  EXPECT_THAT(text, HasSubstr("discharge       0.05;"));
  EXPECT_THAT(text, HasSubstr("area            0.2;"));
  EXPECT_THAT(text, Not(HasSubstr("acceleration")));
}

TEST(StartRegions, HaveTheProfileOfTheParticles) {
  const std::string text = mesh_files(make_foam_case(flume(), 1)).at("system/setFieldsDict");
  const double u = std::sqrt(9.81 * 0.1 * 0.00197);
  for (const double z : {0.005, 0.095}) {
    EXPECT_THAT(text, HasSubstr(fmt::format("volVectorFieldValue U ({:.12g} 0 0)", log_profile(u, z, 1e-6, 1e-3))));
  }
  Case scene = flume();
  scene.flow.start = FlowStart::rest;
  EXPECT_THAT(mesh_files(make_foam_case(scene, 1)).at("system/setFieldsDict"), Not(HasSubstr("volVectorFieldValue")));
}

// k/omega = kappa u* z (1 - z/H), the eddy viscosity of the logarithmic profile.
TEST(Eddies, CarryTheStressOfACurrent) {
  const Current current{0.1, 0.7, 0.044};
  const EddyState eddies = eddies_at(current, 0.03);
  EXPECT_NEAR(eddies.k / eddies.omega, 0.41 * 0.044 * 0.03 * 0.7, 1e-12);
}

// The constant makes the wall function's transition, written here once more, meet 1 + 0.3 ks+.
TEST(WallFunction, HasNikuradsesRoughness) {
  for (const double ks_plus : {20.0, 44.0, 80.0}) {
    const double constant = roughness_constant(1e-3, ks_plus * 1e-3, 1e-6);
    const double transition =
        std::pow((ks_plus - 2.25) / 87.75 + constant * ks_plus, std::sin(0.4258 * (std::log(ks_plus) - 0.811)));
    EXPECT_NEAR(transition, 1 + 0.3 * ks_plus, 1e-9) << ks_plus;
  }
  EXPECT_DOUBLE_EQ(roughness_constant(1e-3, 0.2, 1e-6), 0.3);  // fully rough
}

TEST(WallFunction, IsThatOfEachShape) {
  Case scene = channel();
  scene.shapes.push_back(box("sill", ShapeRole::wall, Vec3(0.2, 0, 0), Vec3(0.3, 0, 0.04)));
  const FoamCase foam_case = make_foam_case(scene, 1);
  const std::string nut = initial_fields(foam_case).at("0.orig/nut");
  EXPECT_THAT(nut, HasSubstr("solids { type nutkRoughWallFunction; Ks uniform 0.001;"));
  EXPECT_THAT(nut, HasSubstr("solids1 { type nutkWallFunction;"));
  EXPECT_THAT(scripts(foam_case).at("Allrun"), HasSubstr("subsetMesh flow -patch solids1 -overwrite"));
  EXPECT_TRUE(mesh_files(foam_case).contains("system/topoSetDict.solids1"));
  scene.model.wall_friction = WallFriction::smooth;
  EXPECT_THAT(initial_fields(make_foam_case(scene, 1)).at("0.orig/nut"), Not(HasSubstr("Rough")));
}

TEST(OverTime, IsLinearBetweenRowsAndConstantBeyond) {
  EXPECT_EQ(over_time({}, {}, 0.04), "0.04");
  EXPECT_EQ(over_time({2, 4, 5}, {0.03, 0.05, 0.05}, 0), "(0.03 + (0.02)*min(max((time() - 2)/2, 0), 1))");
}

TEST(InletConditions, BringTheDischargeInWaterAlone) {
  const FoamCase foam_case = make_foam_case(channel(), 1);
  const std::string velocity = velocity_at(foam_case, opening_patches(foam_case.scene).front());
  const double u = friction_velocity_of_current(0.4, 0.1, 1e-6, 1e-3);
  const std::string shape = fmt::format("log(max((pos().z() - 0)/{:.12g}, 1))", profile_origin(u, 1e-6, 1e-3));
  EXPECT_EQ(velocity, "type exprFixedValue; valueExpr \"vector(1, 0, 0)*(1*0.04)*(alpha.water)*(" + shape +
                          ")/max(weightSum((alpha.water)*(alpha.water)*(" + shape +
                          ")), 1e-9)\"; value uniform (0 0 0);");
}

// Between its rows and columns the product of a hat over the height and a line over the width is the table's plane.
TEST(InletConditions, VaryOverHeightAndWidth) {
  Case scene = channel();
  scene.inlets[0].profile = InletProfile::table;
  scene.inlets[0].section = {{0, 0.1}, {-0.5, 0.5}, {1, 2, 3, 5}};
  const FoamCase foam_case = make_foam_case(scene, 1);
  const std::string up = "min(max(((pos().z() - 0) - 0)/0.1, 0), 1))";
  const std::string across = "min(max((((1)*(pos().y() - (0))) - -0.5)/1, 0), 1))";
  EXPECT_THAT(
      velocity_at(foam_case, opening_patches(foam_case.scene).front()),
      HasSubstr("((1 + (-1)*" + up + "*(1 + (1)*" + across + " + (0 + (1)*" + up + "*(3 + (2)*" + across + ")"));
}

TEST(InletConditions, FillAnOpeningOrStandAtALevel) {
  Case scene = channel();
  scene.inlets[0].surface = InletSurface::full;
  FoamCase foam_case = make_foam_case(scene, 1);
  EXPECT_EQ(alpha_at(foam_case, opening_patches(foam_case.scene)[0]), "type fixedValue; value uniform 1;");
  scene.inlets[0].surface = InletSurface::level;
  scene.inlets[0].times = {0, 10};
  scene.inlets[0].levels = {0.1, 0.14};
  foam_case = make_foam_case(scene, 1);
  EXPECT_THAT(alpha_at(foam_case, opening_patches(foam_case.scene)[0]),
              HasSubstr("(0.1 + (0.04)*min(max((time() - 0)/10, 0), 1)) - pos().z())/0.02 + 0.5"));
}

TEST(OutletConditions, AreThoseOfTheirKind) {
  Case scene = channel();
  FoamCase foam_case = make_foam_case(scene, 1);
  EXPECT_THAT(pressure_at(foam_case, opening_patches(foam_case.scene)[1]), HasSubstr("9810*max((0.1 - pos().z()), 0)"));
  scene.outlets[0].kind = OutletKind::fall;
  foam_case = make_foam_case(scene, 1);
  EXPECT_THAT(pressure_at(foam_case, opening_patches(foam_case.scene)[1]), HasSubstr("prghTotalPressure"));
  scene.outlets[0].kind = OutletKind::pump;
  foam_case = make_foam_case(scene, 1);
  EXPECT_THAT(velocity_at(foam_case, opening_patches(foam_case.scene)[1]), HasSubstr("(1*0.04)*(alpha.water)"));
}

TEST(CurrentRefusal, OfABedThatIsAPhase) {
  Case scene = still_tank();
  scene.domain.periodic = {"x"};
  scene.flow = flume().flow;
  EXPECT_EQ(
      refusal(scene, FoamModel::same_material),
      "tank/case.toml: the mesh model \"same-material\" has no law of the wall over its bed, which a current needs; "
      "use foam.models = [\"eroding-bed\"] (--model eroding-bed), or run this case with --no-foam");
}

TEST(CurrentRefusal, OfAnObliqueInlet) {
  Case scene = channel();
  scene.inlets[0].direction = Vec3(1, 0, -1);
  EXPECT_THAT(refusal(scene), HasSubstr("inlet.west runs obliquely"));
}

TEST(CurrentRefusal, OfAnOpeningInsideTheContainer) {
  Case scene = channel();
  Shape tank = box("tank", ShapeRole::wall, Vec3(-0.1, 0, 0), Vec3(0.6, 0, 0.3));
  tank.side = WallSide::outside;
  scene.shapes.insert(scene.shapes.begin(), tank);
  EXPECT_EQ(
      refusal(scene),
      "flume/case.toml: inlet.west lies at x = 0 m, inside the mesh model's block, which ends at -10 cm; let it lie in "
      "the container's face, or run this case with --no-foam");
}

TEST(CurrentRefusal, OfTwoPlanesOnOneSide) {
  Case scene = channel();
  scene.inlets.push_back(scene.inlets[0]);
  scene.inlets[1].at.x() = 0.1;
  EXPECT_THAT(refusal(scene), HasSubstr("two openings on one side lie at 0 m and at 10 cm"));
}

TEST(CurrentRefusal, OfAnOpeningBehindWalls) {
  Case scene = channel();
  scene.shapes.push_back(box("dam", ShapeRole::wall, Vec3(0, 0, -0.1), Vec3(0.1, 0, 0.3)));
  EXPECT_THAT(refusal(scene), HasSubstr("inlet.west lies behind walls on cells of 2 cm"));
}

TEST(CurrentRefusal, OfGrainsThatComeIn) {
  Case scene = channel();
  scene.inlets[0].grains = InletGrains::uniform;
  EXPECT_THAT(refusal(scene), HasSubstr("inlet.west brings grains, which no mesh model takes in"));
}

TEST(CurrentRefusal, OfAPumpThatDoesNotKnowItsDischarge) {
  Case scene = channel();
  scene.outlets[0].kind = OutletKind::pump;
  scene.inlets[0].discharge = 0;
  scene.inlets[0].velocity = 0.4;
  EXPECT_THAT(refusal(scene), HasSubstr("outlet.east pumps what inlet.west brings"));
}

// Cells with the law's velocities in three places give the law back, with the depth of their water.
TEST(VelocitySampler, FindsTheLawThatTheWaterHas) {
  const FoamCase foam_case = make_foam_case(flume(), 1);
  std::vector<Vec3> centres;
  WaterFields fields;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 15; ++k) {
      const double z = (k + 0.5) * 0.01;
      centres.emplace_back((i + 0.5) * 0.01, 0, z);
      fields.share.push_back(z < 0.1 ? 1 : 0);
      fields.velocity.emplace_back(log_profile(0.044, z, 1e-6, 1e-3), 0, 0);
    }
  }
  VelocitySampler sampler(foam_case, centres);
  sampler.add(fields);
  const std::vector<SampledStation> stations = sampler.stations();
  ASSERT_EQ(stations.size(), 3U);
  EXPECT_NEAR(stations[1].place, 0.1, 1e-12);
  EXPECT_NEAR(stations[1].ground, 0, 1e-12);
  EXPECT_NEAR(stations[1].depth, 0.1, 1e-12);
  ASSERT_EQ(stations[1].height.size(), 10U);
  double mean = 0;
  for (const double velocity : stations[1].velocity) mean += velocity / 10;
  EXPECT_NEAR(stations[1].mean_velocity, mean, 1e-12);
  EXPECT_NEAR(stations[1].friction_velocity, friction_velocity_of_current(mean, 0.1, 1e-6, 1e-3), 1e-9);
  EXPECT_NEAR(stations[1].friction_velocity, 0.044, 5e-4);  // the mean of ten rows is not quite that of the law
  EXPECT_NEAR(stations[1].velocity[4], log_profile(0.044, 0.045, 1e-6, 1e-3), 1e-12);
}

}  // namespace
}  // namespace thalweg::foam
