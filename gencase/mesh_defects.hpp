#pragma once

#include <string>

#include "common/io/surface_file.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

/// What keeps a surface from bounding a volume.
struct MeshDefects {
  std::size_t holes = 0;
  double hole_length = 0;          // [m] of all open edges
  double longest_hole = 0;         // [m]
  std::size_t crowded_edges = 0;   // edges of more than two faces
  std::size_t opposed_edges = 0;   // edges whose two faces are turned against each other
  std::size_t degenerate = 0;      // faces without area
  std::size_t intersections = 0;   // pairs of faces that intersect; sought only in surfaces without the other defects
  std::size_t between_bodies = 0;  // of these, pairs of different bodies
  LineSet places;                  // to look at: 1 open edges, 2 crowded, 3 opposed, 4 degenerate, 5 intersecting

  [[nodiscard]] bool any() const { return holes + crowded_edges + opposed_edges + degenerate + intersections > 0; }
  /// "2 holes with 31 cm of open edges (the longest 20 cm), 3 faces without area".
  [[nodiscard]] std::string text() const;
};

/// `closed`: whether open edges are a defect.
MeshDefects find_defects(const Triangles& surface, bool closed);

/// Least thickness of a closed surface's body: the distance to the opposite side, met head-on, from the middle of a
/// face inward [m]; and the share of the skin thinner than `limit`. Looks at some thousand faces.
struct Thickness {
  double least = 0;
  double thin_share = 0;
  Vec3 where = Vec3::Zero();
};
Thickness thickness_of(const Triangles& surface, double limit);

}  // namespace thalweg::gencase
