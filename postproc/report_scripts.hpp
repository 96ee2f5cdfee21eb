#pragma once

#include <filesystem>
#include <vector>

#include "postproc/report.hpp"

namespace thalweg {

/// Writes the tables and scripts of the report's pictures of the bed: depth and volume over time, map, sections, shear
/// stress. Returns the scripts. Throws RunError.
std::vector<std::filesystem::path> bed_scripts(const ReportInput& input, const std::filesystem::path& pictures);

}  // namespace thalweg
