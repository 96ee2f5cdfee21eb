#pragma once

#include "common/run_folder.hpp"

namespace thalweg {

/// Lets the log show what --quiet, --verbose and --json ask for (common/console.hpp).
void start_console();

/// From now on the log goes into the run's folder too (common/console.hpp), its warnings also among those of the report
/// (common/warnings.hpp).
void keep_warnings(const RunFolder& run);

}  // namespace thalweg
