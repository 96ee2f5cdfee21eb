#pragma once

#include <vector>

#include "common/csv.hpp"

namespace thalweg {

/// A table of values over time that a case names as a file has to have two rows at least; each needs a time from 0 s on,
/// after that of the row before, and a value. `times` [s] and `values` (any unit) are columns of the table, an entry for
/// each row. Throws InputError "file:line: what is wrong; what to do".
void check_time_rows(const CsvTable& table, const std::vector<double>& times, const std::vector<double>& values);

}  // namespace thalweg
