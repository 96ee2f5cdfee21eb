#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The inside of a closed surface of triangles, oriented outward. Where parts of the surface overlap, everything inside
/// one of them counts.
RegionPointer make_polyhedron(Triangles surface);

/// What lies within half of `thickness` [m] of a surface of triangles, open or closed.
RegionPointer make_plate(Triangles surface, double thickness);

/// Volume [m^3] enclosed by a closed surface, negative when it is inside out.
double volume(const Triangles& surface);

Bounds bounds_of(const Triangles& surface);

}  // namespace thalweg::gencase
