#include <gmock/gmock.h>

#include "foam_reference/case_files.hpp"
#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(BlockMeshDict, HoldsTheContainersGeometry) {
  const std::string text = mesh_files(make_foam_case(still_tank(), 1)).at("system/blockMeshDict");
  EXPECT_THAT(text, HasSubstr("hex (0 1 2 3 4 5 6 7) (40 1 15) simpleGrading (1 1 1)"));
  EXPECT_THAT(text, HasSubstr("    (0 -0.5 0)\n    (0.4 -0.5 0)\n    (0.4 0.5 0)\n    (0 0.5 0)\n"
                              "    (0 -0.5 0.15)\n    (0.4 -0.5 0.15)\n    (0.4 0.5 0.15)\n    (0 0.5 0.15)\n"));
  EXPECT_THAT(text, HasSubstr("atmosphere\n    {\n        type patch;\n        faces ( (4 5 6 7) );"));
  EXPECT_THAT(text, HasSubstr("walls\n    {\n        type wall;\n        faces ( (0 4 7 3) (1 2 6 5) (0 3 2 1) );"));
  EXPECT_THAT(text, HasSubstr("frontAndBack\n    {\n        type empty;\n        faces ( (0 1 5 4) (3 7 6 2) );"));
}

TEST(BlockMeshDict, PairsPeriodicFaces) {
  Case scene = still_tank();
  scene.domain.periodic = {"x"};
  const std::string text = mesh_files(make_foam_case(scene, 1)).at("system/blockMeshDict");
  EXPECT_THAT(text, HasSubstr("minusX\n    {\n        type cyclic;\n        neighbourPatch plusX;\n"
                              "        faces ( (0 4 7 3) );"));
  EXPECT_THAT(text, HasSubstr("plusX\n    {\n        type cyclic;\n        neighbourPatch minusX;\n"
                              "        faces ( (1 2 6 5) );"));
}

TEST(SetFieldsDict, FillsTheShapesInTheCasesOrder) {
  const std::string text = mesh_files(make_foam_case(still_tank(), 1)).at("system/setFieldsDict");
  const std::size_t bed = text.find("box (0 -0.5 0) (0.4 0.5 0.05);");
  const std::size_t pool = text.find("box (0 -0.5 0.05) (0.4 0.5 0.1);");
  ASSERT_NE(bed, std::string::npos);
  ASSERT_NE(pool, std::string::npos);
  EXPECT_LT(bed, pool);
  EXPECT_THAT(text.substr(bed, pool - bed),
              HasSubstr("volScalarFieldValue alpha.water 0 volScalarFieldValue alpha.sediment 1 volScalarFieldValue "
                        "alpha.air 0"));
  EXPECT_THAT(text.substr(pool), HasSubstr("volScalarFieldValue alpha.water 1"));
}

// Cells of 20 mm have centres at 0.05 m: both shapes' faces move up alike, so no cell is filled twice or left out.
TEST(SetFieldsDict, MovesFacesOffTheCellsCentres) {
  Case scene = still_tank();
  scene.foam.cell = 0.02;
  const std::string text = mesh_files(make_foam_case(scene, 1)).at("system/setFieldsDict");
  EXPECT_THAT(text, HasSubstr("box (0 -0.5 0) (0.4 0.5 0.05002);"));
  EXPECT_THAT(text, HasSubstr("box (0 -0.5 0.05002) (0.4 0.5 0.1);"));
}

Shape disc(const std::string& name, ShapeRole role) {
  Shape shape;
  shape.name = name;
  shape.kind = ShapeKind::sphere;
  shape.role = role;
  shape.center = Vec3(0.2, 0, 0.08);
  shape.radius = 0.02;
  return shape;
}

TEST(SetFieldsDict, KnowsRoundShapesInPlaneAndSpace) {
  Case scene = still_tank();
  scene.shapes.push_back(disc("bubble", ShapeRole::empty));
  EXPECT_THAT(mesh_files(make_foam_case(scene, 1)).at("system/setFieldsDict"),
              HasSubstr("cylinderToCell  // shape \"bubble\"\n    {\n        p1 (0.2 -0.5 0.08); p2 (0.2 0.5 0.08); "
                        "radius 0.02;"));
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.1;
  EXPECT_THAT(mesh_files(make_foam_case(scene, 1)).at("system/setFieldsDict"),
              HasSubstr("sphereToCell  // shape \"bubble\"\n    {\n        origin (0.2 0 0.08); radius 0.02;"));
}

TEST(TopoSetDict, BuildsCombinedShapesFromTheirParts) {
  Case scene = still_tank();
  scene.shapes.push_back(disc("ball", ShapeRole::none));
  Shape rest;
  rest.name = "rest of the pool";
  rest.kind = ShapeKind::combine_difference;
  rest.role = ShapeRole::water;
  rest.of = {"pool", "ball"};
  scene.shapes.push_back(rest);
  const CaseFiles files = mesh_files(make_foam_case(scene, 1));
  const std::string sets = files.at("system/topoSetDict.shapes");
  EXPECT_THAT(sets, HasSubstr("{ name shape4; type cellSet; action new; source boxToCell; box (0 -0.5 0.05) (0.4 0.5 "
                              "0.1); }\n    { name shape4; type cellSet; action subtract; source cylinderToCell; "));
  EXPECT_THAT(files.at("system/setFieldsDict"), HasSubstr("cellToCell  // shape \"rest of the pool\"\n    {\n        "
                                                          "set shape4;"));
  EXPECT_THAT(scripts(make_foam_case(scene, 1)).at("Allrun"), HasSubstr("topoSet -dict system/topoSetDict.shapes"));
}

TEST(TopoSetDict, TakesSolidWallsOutOfTheMesh) {
  Case scene = still_tank();
  scene.shapes.push_back(box("sill", ShapeRole::wall, Vec3(0.1, 0, 0), Vec3(0.2, 0, 0.08)));
  const FoamCase foam_case = make_foam_case(scene, 1);
  const CaseFiles files = case_files(foam_case);
  EXPECT_THAT(files.at("system/topoSetDict.solids"),
              HasSubstr("{ name flow; type cellSet; action subtract; source boxToCell; box (0.1 -0.5 0) (0.2 0.5 "
                        "0.08); }"));
  EXPECT_THAT(files.at("Allrun"), HasSubstr("subsetMesh flow -patch solids -overwrite"));
  EXPECT_THAT(files.at("0.orig/U"), HasSubstr("    solids { type noSlip; }"));
  EXPECT_THAT(case_files(make_foam_case(still_tank(), 1)).at("Allrun"), Not(HasSubstr("subsetMesh")));
}

TEST(DecomposeParDict, CutsTheLongestSide) {
  EXPECT_THAT(mesh_files(make_foam_case(still_tank(), 3)).at("system/decomposeParDict"), HasSubstr("n (3 1 1);"));
  EXPECT_FALSE(mesh_files(make_foam_case(still_tank(), 1)).contains("system/decomposeParDict"));
}

}  // namespace
}  // namespace thalweg::foam
