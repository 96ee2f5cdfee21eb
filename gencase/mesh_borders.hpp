#pragma once

#include <cstddef>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Closes slits between the open edges of a surface that are no wider than `width` [m]: points of open edges that lie
/// on or beside another open edge become one point of both, which cures edges that end in the middle of another one
/// (T-junctions) and parts that were drawn apart. Narrow slits come first, so that small faces beside them last.
/// Returns the number of open edges that were closed.
std::size_t close_slits(Triangles& surface, double width);

/// Takes away loose faces: connected parts with open edges that no body is missing. They have less than a twentieth of
/// the surface's area, and what remains is closed. Returns their number of faces.
std::size_t drop_loose_faces(Triangles& surface);

}  // namespace thalweg::gencase
