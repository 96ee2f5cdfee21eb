#pragma once

#include <filesystem>
#include <iosfwd>

#include "common/io/surface_file.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

enum class MeshFormat { stl, obj, off, ply };

/// Reads a surface. Throws InputError "what is wrong; what to do" (without the name of the file) when the bytes are not
/// of this format, announce more than there is, hold no face, a face of fewer than three corners, a corner that does
/// not exist, or a coordinate that is no number.
PolygonSoup read_mesh(std::istream& from, MeshFormat format);

/// The surface in a file, by its extension (.stl, .obj, .off, .ply, .vtp), in the file's unit. Throws InputError as
/// above, beginning with the file's name.
PolygonSoup read_mesh(const std::filesystem::path& file);

/// Splits the polygons into triangles and joins points in the same place.
Triangles triangulate(const PolygonSoup& soup);

}  // namespace thalweg::gencase
