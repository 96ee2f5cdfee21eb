#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "foam_reference/shapes.hpp"

namespace thalweg::foam {

/// Kind of a face of the block of cells; `unused` closes a 2-D block along y.
enum class Face { wall, open, periodic, unused };

/// The block of equal cells in which the mesh model computes a scene.
struct MeshPlan {
  Vec3 low = Vec3::Zero();                     // [m]
  Vec3 high = Vec3::Zero();                    // [m]
  std::array<std::int64_t, 3> cells{1, 1, 1};  // [-] along x, y, z
  std::array<Face, 6> faces{};                 // -x +x -y +y -z +z
  bool has_solids = false;                     // solid walls are taken out of the block
  bool has_surfaces = false;                   // solid walls from surface meshes are taken out by snappyHexMesh
  double cell = 0;                             // [m] wanted; size() is the nearest that fits the container
  std::vector<Vec3> flow_points;               // [m] in each region of cells that is kept; without any, all of them are

  [[nodiscard]] Vec3 size() const;                                    // [m] of one cell
  [[nodiscard]] double cell_volume() const { return size().prod(); }  // [m^3]; 2-D: per metre of width
  [[nodiscard]] std::int64_t cell_count() const { return cells[0] * cells[1] * cells[2]; }
  [[nodiscard]] bool open(Face kind) const;  // true if any face is of this kind
};

/// Volumes of the fluids in the shapes, which do not depend on the cells.
struct SceneContents {
  double water_volume = 0;     // [m^3]; 2-D: [m^3/m]
  double sediment_volume = 0;  // [m^3]; 2-D: [m^3/m]
  double bed_thickness = 0;    // [m] mean over the columns that hold sediment
  double water_area = 0;       // [m^2] of the columns that hold water, seen from above; 2-D: [m^2/m]
};

/// Cell size [m] of the mesh model: foam.cell, or twice the particle spacing.
double cell_size(const Case& scene);

/// Counts the cells between the plan's corners. Throws InputError for fewer than 2 along an axis, or too many in all.
void count_cells(const Case& scene, MeshPlan& plan);

/// Plans the block of cells: the inside of the container (the one wall shape with side = "outside", a box); an open top
/// lies foam.open_above over the fluid's highest point at the start. A scene with a current needs no container
/// (current_block.hpp). A 2-D block is 1 m wide, so that volumes are per metre of width. Throws InputError for a scene
/// that the mesh model cannot compute.
MeshPlan plan_mesh(const Case& scene);

/// Volumes of the shapes inside the block, from 4 x 4 points a cell in 2-D, 2 x 2 x 2 in 3-D. Throws InputError when
/// they are all empty.
SceneContents measure_contents(const Case& scene, const MeshPlan& plan);

}  // namespace thalweg::foam
