#pragma once

#include <string>
#include <vector>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// A patch of walls, all of one roughness.
struct WallPatch {
  std::string name;
  double roughness = 0;  // [m] Nikuradse's; 0: smooth
};

/// The container "walls", if it has one; the solids taken out of the block, "solids", "solids1", …, one for each
/// roughness; and "surface3", …, of each meshed solid. Without wall functions roughness means nothing, and is 0.
std::vector<WallPatch> wall_patches(const FoamCase& foam_case);

/// The roughness [m] of each of "solids", "solids1", …; none without solids.
std::vector<double> solid_roughnesses(const FoamCase& foam_case);

/// Name of the patch of solids at an index of solid_roughnesses.
std::string solids_patch(std::size_t index);

/// Roughness [m] of a wall shape that its patch has.
double roughness_of(const FoamCase& foam_case, const Shape& shape);

}  // namespace thalweg::foam
