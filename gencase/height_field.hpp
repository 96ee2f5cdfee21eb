#pragma once

#include <stdexcept>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Thrown for a surface that does not have one height for each x and y; what() says "what is wrong; what to do".
struct NoHeightField : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The Delaunay triangulation of measured points in x and y. No two of them may have the same x and y.
/// Throws NoHeightField for points on one line.
Triangles triangulated(const std::vector<Vec3>& points);

/// The closed surface of the body between an open surface and the height `base` [m] below it. Throws NoHeightField if
/// the surface overhangs or is vertical somewhere.
Triangles closed_downward(const Triangles& top, double base);

}  // namespace thalweg::gencase
