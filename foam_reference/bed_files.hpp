#pragma once

#include <string>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// Name of the function object, and of its folder in postProcessing.
inline constexpr const char* eroding_bed_name = "bed";

/// Drag on water in the bed [1/s]. It stops the water within a tenth of a millisecond, far below a step.
inline constexpr double bed_drag = 1e4;

/// The function object in system/controlDict that moves the bed.
std::string eroding_bed_function(const FoamCase& foam_case);

}  // namespace thalweg::foam
