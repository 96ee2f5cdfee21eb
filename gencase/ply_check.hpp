#pragma once

#include <string>

namespace thalweg::gencase {

/// Looks through the header and the data of a PLY file, in text or binary, for what CGAL's reader trusts unseen: types
/// it does not know, a property before any element, a list that announces more numbers than the file holds (it takes
/// the memory first and then reads them all). Throws InputError "what is wrong; what to do" without the name of the
/// file.
void check_ply(const std::string& bytes);

}  // namespace thalweg::gencase
