#pragma once

#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// The times at which snapshots are written, ascending and distinct: the start, multiples of output.interval,
/// output.times, compare.times, the end.
std::vector<double> snapshot_times(const Case& of);

}  // namespace thalweg
