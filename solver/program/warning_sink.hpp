#pragma once

#include "common/run_folder.hpp"

namespace thalweg {

/// From now on the log's warnings are kept in the run's folder too (common/warnings.hpp).
void keep_warnings(const RunFolder& run);

}  // namespace thalweg
