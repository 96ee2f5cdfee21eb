// Solid walls from surface meshes: their files, and system/snappyHexMeshDict that takes their inside out of the mesh.
#include "foam_reference/surface_files.hpp"

#include <fstream>
#include <iterator>

#include "common/error.hpp"
#include "foam_reference/dictionary.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const Case& scene, const Shape& shape) {
  const fs::path file = scene.folder / shape.file;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(place(scene, shape) + ": " + file.string() + " cannot be read; check `file` of \"" + shape.name +
                     "\"");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A number, since a shape's name may hold characters that a patch's name may not.
std::string surface_name(const Case& scene, const Shape& shape) {
  return "surface" + std::to_string(&shape - scene.shapes.data());
}

std::string file_name(const Case& scene, const Shape& shape) {
  return surface_name(scene, shape) + fs::path(shape.file).extension().string();
}

std::vector<const Shape*> surfaces(const Case& scene) {
  std::vector<const Shape*> found;
  for (const Shape& shape : scene.shapes) {
    if (is_meshed_solid(scene, shape)) found.push_back(&shape);
  }
  return found;
}

std::string snappy(const FoamCase& foam_case) {
  std::string geometry;
  std::string refinement;
  for (const Shape* shape : surfaces(foam_case.scene)) {
    const std::string name = surface_name(foam_case.scene, *shape);
    geometry += "    " + file_name(foam_case.scene, *shape) + " { type triSurfaceMesh; name " + name +
                "; }  // shape \"" + shape->name + "\"\n";
    refinement += "        " + name + " { level (0 0); patchInfo { type wall; } }\n";
  }
  // A point near the uppermost corner of the flow that lies on no face of a cell.
  const Vec3 inside = foam_case.plan.high - 0.3719 * foam_case.plan.size();
  return substitute(R"(castellatedMesh true;
snap            false;
addLayers       false;

geometry
{
%geometry%}

castellatedMeshControls
{
    maxLocalCells   100000000;
    maxGlobalCells  200000000;
    minRefinementCells 0;
    nCellsBetweenLevels 2;
    features        ();
    refinementSurfaces
    {
%refinement%    }
    resolveFeatureAngle 30;
    refinementRegions {}
    locationInMesh  %inside%;
    allowFreeStandingZoneFaces true;
}

snapControls
{
    nSmoothPatch    3;
    tolerance       2;
    nSolveIter      30;
    nRelaxIter      5;
    nFeatureSnapIter 10;
    implicitFeatureSnap true;
    explicitFeatureSnap false;
}

addLayersControls { relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1; }

meshQualityControls
{
    maxNonOrtho     60;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave      80;
    minVol          1e-18;
    minTetQuality   1e-15;
    minArea         -1;
    minTwist        0.02;
    minDeterminant  0.001;
    minFaceWeight   0.05;
    minVolRatio     0.01;
    minTriangleTwist -1;
    nSmoothScale    4;
    errorReduction  0.75;
}

mergeTolerance  1e-6;
)",
                    {{"geometry", geometry}, {"refinement", refinement}, {"inside", vector(inside)}});
}

}  // namespace

CaseFiles surface_files(const FoamCase& foam_case) {
  if (!foam_case.plan.has_surfaces) return {};
  const Case& scene = foam_case.scene;
  CaseFiles files;
  for (const Shape* shape : surfaces(scene)) {
    files["constant/surfaces/" + file_name(scene, *shape)] = contents_of(scene, *shape);
  }
  files["system/snappyHexMeshDict"] = foam_file(
      scene, "dictionary", "snappyHexMeshDict",
      "Cells inside the surfaces are taken out, whole cells, as for other solid walls. A higher `level` halves the "
      "cells there.\n`snap true` fits them to the surface, but then interFoam and multiphaseInterFoam 1912 diverged "
      "within milliseconds.",
      snappy(foam_case));
  return files;
}

std::string surface_steps(const FoamCase& foam_case) {
  if (!foam_case.plan.has_surfaces) return "";
  const Case& scene = foam_case.scene;
  std::string text = "mkdir -p constant/triSurface || exit 1\n";
  for (const Shape* shape : surfaces(scene)) {
    const std::string name = surface_name(scene, *shape);
    const std::string file = file_name(scene, *shape);
    const Vec3 move = shape->move.empty() ? Vec3::Zero() : Vec3(shape->move[0], shape->move[1], shape->move[2]);
    const std::string scaled = "constant/triSurface/scaled_" + file;
    text += "step scale." + name + " surfaceTransformPoints -scale " + number(shape->scale) + " constant/surfaces/" +
            file + " " + scaled + "\nstep move." + name + " surfaceTransformPoints -translate '" + vector(move) + "' " +
            scaled + " constant/triSurface/" + file + "\n";
  }
  return text + "step snappyHexMesh snappyHexMesh -overwrite\n";
}

}  // namespace thalweg::foam
