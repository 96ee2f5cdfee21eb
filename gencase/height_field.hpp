#pragma once

#include <stdexcept>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// A surface that is no height over x and y; what() says "what is wrong; what to do".
struct NoHeightField : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Triangles between measured points, by Delaunay's rule in x and y. Throws NoHeightField for two heights at one place
/// and for points on one line.
Triangles triangulated(const std::vector<Vec3>& points);

/// The closed surface around what lies between an open surface and the height `base` [m] below it. Throws NoHeightField
/// when the surface overhangs or stands upright somewhere.
Triangles closed_downward(const Triangles& top, double base);

}  // namespace thalweg::gencase
