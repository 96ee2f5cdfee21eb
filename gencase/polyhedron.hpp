#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The inside of a closed surface of triangles that are oriented outward. If parts of the surface overlap, it is the
/// union of their insides.
RegionPointer make_polyhedron(Triangles surface);

/// The points within half of `thickness` [m] of a surface of triangles, which may be open or closed.
RegionPointer make_plate(Triangles surface, double thickness);

/// Volume [m^3] enclosed by a closed surface, negative when it is inside out.
double volume(const Triangles& surface);

/// Bounds of a surface; it must have points.
Bounds bounds_of(const Triangles& surface);

}  // namespace thalweg::gencase
