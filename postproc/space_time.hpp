#pragma once

#include <filesystem>

#include "postproc/report.hpp"

namespace thalweg {

/// Writes the table from profiles/all or, where there are none, from the profiles at the case's times.
/// Without a bed or with a single time nothing is written and `times` is 0. Throws RunError.
BedHistory write_bed_history(const std::filesystem::path& file, const ReportInput& input);

}  // namespace thalweg
