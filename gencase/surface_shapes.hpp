#pragma once

#include <string>

#include "case/case.hpp"
#include "gencase/notes.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

/// "case.toml:12: shape "pier"", the beginning of every message about a shape.
std::string where(const Case& scene, const Shape& shape);

/// The body in a mesh file. Looks for everything that keeps its surface from bounding a volume, repairs it where the
/// shape asks for that, and throws InputError with shape, line, file, cause and cure where it cannot be used:
/// unreadable, open, badly oriented, without area, intersecting itself, thinner than two spacings, of an unlikely unit,
/// outside of the domain. The places of its defects are drawn as lines.
RegionPointer make_mesh(const Case& scene, const Shape& shape, double plate_thickness, const Notes& notes);

/// The body between a measured surface and the height shape.base. Throws InputError like make_mesh, and when the
/// surface overhangs, reaches below the base or gives two heights for one place.
RegionPointer make_bathymetry(const Case& scene, const Shape& shape, const Notes& notes);

}  // namespace thalweg::gencase
