#include "case/tables/time_table.hpp"

#include <cmath>

#include "common/error.hpp"

namespace thalweg {

void check_time_rows(const CsvTable& table, const std::vector<double>& times, const std::vector<double>& values) {
  if (values.size() < 2) throw InputError(table.where() + ": the table has less than two rows; add some");
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row]) || !(times[row] >= 0) || !std::isfinite(times[row])) {
      throw InputError(table.where(row) + ": the row lacks a number or its time is negative; give both");
    }
    if (row > 0 && !(times[row] > times[row - 1])) {
      throw InputError(table.where(row) + ": the time is not after that of the row before; sort the rows");
    }
  }
}

}  // namespace thalweg
