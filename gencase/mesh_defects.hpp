#pragma once

#include <string>

#include "common/io/surface_file.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Defects because of which a surface does not bound a volume.
struct MeshDefects {
  std::size_t holes = 0;
  double hole_length = 0;          // [m] of all open edges
  double longest_hole = 0;         // [m]
  std::size_t crowded_edges = 0;   // edges of more than two faces
  std::size_t opposed_edges = 0;   // edges whose two faces are turned against each other
  std::size_t degenerate = 0;      // faces without area
  std::size_t intersections = 0;   // pairs of faces that intersect; searched only if there is no other defect
  std::size_t between_bodies = 0;  // of these, pairs of different bodies
  LineSet places;                  // for a picture: 1 open edges, 2 crowded, 3 opposed, 4 degenerate, 5 intersecting

  [[nodiscard]] bool any() const { return holes + crowded_edges + opposed_edges + degenerate + intersections > 0; }
  /// "2 holes with 31 cm of open edges (the longest 20 cm), 3 faces without area".
  [[nodiscard]] std::string text() const;
};

/// The use of a surface, which decides what counts as a defect of it.
enum class SurfaceUse {
  body,    // bounds a volume
  ground,  // has one height for each place: open edges are none
  plate    // its points' distance alone counts: it may be open, and its sheets may meet and cross
};

/// Searches a surface for defects. Bodies that touch in edges and corners are none.
MeshDefects find_defects(const Triangles& surface, SurfaceUse use);

/// Thickness of a closed surface's body: the distance from the middle of a face inward to the opposite side.
struct Thickness {
  double least = 0;           // [m]
  double thin_share = 0;      // [-] share of the surface that is thinner than the limit
  Vec3 where = Vec3::Zero();  // [m] place of the least thickness
};

/// Measures the thickness at up to some thousand faces; `limit` [m] is that of `thin_share`.
Thickness thickness_of(const Triangles& surface, double limit);

/// A number with its noun: "1 face", "2 faces".
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace thalweg::gencase
