#pragma once

#include <string>

#include "gencase/generate.hpp"

namespace thalweg::gencase {

/// The summary that gencase prints: particles of each shape with filled and exact volume, numbers and masses per type,
/// bounds, sound speed, largest hydrostatic pressure.
std::string report(const Generated& generated);

}  // namespace thalweg::gencase
