#pragma once

#include <string>

#include "case/case.hpp"
#include "gencase/notes.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

/// "case.toml:12: shape "pier"", the beginning of every message about a shape.
std::string where(const Case& scene, const Shape& shape);

/// The body in a mesh file. Searches its surface for defects and repairs it if the shape asks for that. Throws
/// InputError with shape, line, file, cause and cure if it cannot be used: unreadable, open, badly oriented, without
/// area, intersecting itself, thinner than two spacings, of an unlikely unit, outside of the domain. The defects are
/// drawn as lines by `notes.draw`.
RegionPointer make_mesh(const Case& scene, const Shape& shape, double plate_thickness, const Notes& notes);

/// The body between a measured surface and the height shape.base. Throws InputError like make_mesh, and if the surface
/// overhangs, reaches below the base or gives two heights for one place.
RegionPointer make_bathymetry(const Case& scene, const Shape& shape, const Notes& notes);

}  // namespace thalweg::gencase
