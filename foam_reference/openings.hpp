#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "foam_reference/mesh_plan.hpp"

namespace thalweg::foam {

/// An inlet or outlet as a patch of the block's outer face. Lives no longer than its case.
struct OpeningPatch {
  std::string patch;     // "inlet0", "outlet1": a case's names may hold characters that a patch's may not
  std::size_t face = 0;  // of the block: -x +x -y +y -z +z
  const Opening* opening = nullptr;
  const Inlet* inlet = nullptr;  // one of the two
  const Outlet* outlet = nullptr;
};

/// True if water runs through the scene: around a period, or through inlets and outlets.
bool has_current(const Case& scene);

/// The inlets and outlets of the case, in its order. Throws InputError for one that runs obliquely to the block's faces.
std::vector<OpeningPatch> opening_patches(const Case& scene);

/// Coordinate [m] of an opening's plane along its axis.
double plane_of(const OpeningPatch& patch);

/// True if its plane stands upright, so that it has a level.
bool is_upright(const OpeningPatch& patch);

/// Bounds [m] of an opening in the block's outer face, with a hundredth of a cell along its axis to both sides; in 2-D
/// through the whole width of the block.
Bounds bounds_of(const OpeningPatch& patch, const MeshPlan& plan, int dimension);

/// Depth [m] of the water at an inlet that the case can tell: that of its level at the start, or of the water that stands
/// before its plane, or the opening's whole extent.
double depth_at(const Case& scene, const MeshPlan& plan, const OpeningPatch& patch);

/// Throws InputError for inlets and outlets that the mesh model cannot compute, in one line with its cure.
void check_openings(const Case& scene, const MeshPlan& plan);

}  // namespace thalweg::foam
