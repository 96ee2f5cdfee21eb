#pragma once

#include <filesystem>

#include "postproc/report.hpp"

namespace thalweg {

/// Writes the table from the profiles of all snapshots. Without a bed or with a single time nothing is written and
/// `times` is 0. Throws RunError.
BedHistory write_bed_history(const std::filesystem::path& file, const ReportInput& input);

}  // namespace thalweg
