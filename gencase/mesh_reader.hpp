#pragma once

#include <filesystem>
#include <iosfwd>

#include "gencase/region.hpp"
#include "gencase/text_meshes.hpp"

namespace thalweg::gencase {

enum class MeshFormat { stl, obj, off, ply };

/// Reads a surface. Throws InputError "what is wrong; what to do" (without the name of the file) if the bytes are not
/// of this format or are cut off, hold no face, a face of fewer than three corners, a corner that does not exist, or a
/// coordinate that is no number.
MeshFile read_mesh(std::istream& from, MeshFormat format);

/// Reads the surface in a file, in the file's unit. The extension tells the format (.stl, .obj, .off, .ply, .vtp).
/// Throws InputError as above, beginning with the file's name.
MeshFile read_mesh(const std::filesystem::path& file);

/// Splits the polygons into triangles and joins points with equal coordinates.
Triangles triangulate(const PolygonSoup& soup);

}  // namespace thalweg::gencase
