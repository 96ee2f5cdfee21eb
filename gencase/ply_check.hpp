#pragma once

#include <string>

namespace thalweg::gencase {

/// Checks the header and the data of a PLY file, text or binary, for faults that CGAL's reader does not check: unknown
/// types, a property before any element, a list that announces more numbers than the file holds (the reader allocates
/// their memory before it reads them). Throws InputError "what is wrong; what to do" without the name of the file.
void check_ply(const std::string& bytes);

}  // namespace thalweg::gencase
