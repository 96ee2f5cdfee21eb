#pragma once

#include <string>

#include "gencase/generate.hpp"

namespace thalweg::gencase {

/// The summary gencase prints: shapes with filled against exact volume, counts and masses per type, bounds, sound
/// speed, largest hydrostatic pressure.
std::string report(const Generated& generated);

}  // namespace thalweg::gencase
