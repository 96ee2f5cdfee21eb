#pragma once

#include <string>
#include <vector>

#include "common/io/surface_file.hpp"

namespace thalweg::gencase {

/// A surface and what its reader left out of it, one clause each.
struct MeshFile {
  PolygonSoup soup;  // in the file's unit
  std::vector<std::string> remarks;
};

/// Reads an STL file, text or binary. The size settles which: a binary file has 84 bytes and 50 for each of the facets
/// that it announces, whatever its name begins with. The words of a text may be in capitals, its parts separated by
/// any blanks, and its last line may be missing. Throws InputError "what is wrong; what to do".
MeshFile read_stl(const std::string& bytes);

/// Reads the points and faces of an OBJ file; lines may be continued by a backslash. Lines and points beside the faces
/// are left out with a remark. Throws InputError "line 4: what is wrong; what to do".
MeshFile read_obj(const std::string& bytes);

/// Reads the points and faces of an OFF file, one a line; colours and normals are left out. Throws InputError "line 4:
/// what is wrong; what to do".
MeshFile read_off(const std::string& bytes);

/// Refuses a file that announces more elements than its bytes can hold, before a reader allocates memory for them.
/// `least` [bytes] is the size of the smallest element of the format. Throws InputError.
void check_count(const std::string& what, double announced, double bytes, double least);

}  // namespace thalweg::gencase
