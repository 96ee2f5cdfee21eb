#pragma once

#include <string>
#include <vector>

#include "foam_reference/case_files.hpp"

// Names of what is written at every step about patches that water can cross.
namespace thalweg::foam {

/// The patches that let water out or in: "atmosphere", if a face is open, then inlets and outlets.
std::vector<std::string> open_patches(const FoamCase& foam_case);

/// Name of the function that writes the volume of a phase per time out of a patch, and of its folder.
std::string outflow_of(const std::string& phase, const std::string& patch);

/// Name of the function that writes the wetted area of a patch.
std::string wet_area_of(const std::string& patch);

}  // namespace thalweg::foam
