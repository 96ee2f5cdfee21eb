#include "case/tables/velocity_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/tables/between.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

std::vector<double> sorted_once(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t place_of(const std::vector<double>& sorted, double value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

}  // namespace

double VelocitySection::speed_at(double height, double place_across) const {
  if (speeds.empty()) return 0;
  const std::size_t columns = std::max<std::size_t>(1, across.size());
  // Tables of unequal length are refused, but other tables are checked against them before that is told.
  const std::size_t rows = std::min(heights.size(), speeds.size() / columns);
  if (rows == 0) return 0;
  const Between row = between(heights, rows, height);
  const Between column = across.empty() ? Between{} : between(across, columns, place_across);
  const auto at_row = [&](std::size_t n) {
    const double* begin = speeds.data() + n * columns;
    return column.mix(begin[column.below], begin[column.above()]);
  };
  return row.mix(at_row(row.below), at_row(row.above()));
}

VelocitySection read_velocity_section(const std::filesystem::path& file) {
  const CsvTable table = CsvTable::read(file);
  const std::vector<double> heights = table.numbers("height", "m");
  const std::vector<double> speeds = table.numbers("speed", "m/s");
  const bool in_space = table.has("across");
  const std::vector<double> across = in_space ? table.numbers("across", "m") : std::vector<double>(heights.size(), 0.0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isfinite(heights[row]) && std::isfinite(across[row]) && heights[row] >= 0 && speeds[row] >= 0 &&
        std::isfinite(speeds[row]))
      continue;
    throw InputError(table.where(row) + ": the row lacks a number, or has a height or speed below 0; correct it");
  }
  VelocitySection section{sorted_once(heights), sorted_once(across), {}};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  section.speeds.assign(section.heights.size() * section.across.size(), none);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    double& speed = section.speeds[place_of(section.heights, heights[row]) * section.across.size() +
                                   place_of(section.across, across[row])];
    if (!std::isnan(speed)) throw InputError(table.where(row) + ": a row before it has the same place; remove one");
    speed = speeds[row];
  }
  const auto missing =
      std::find_if(section.speeds.begin(), section.speeds.end(), [](double v) { return std::isnan(v); });
  if (missing != section.speeds.end()) {
    const auto n = static_cast<std::size_t>(missing - section.speeds.begin());
    throw InputError(fmt::format(
        "{}: no row has height {:g} m and across {:g} m; give one for each height at each place across", table.where(),
        section.heights[n / section.across.size()], section.across[n % section.across.size()]));
  }
  if (section.speeds.size() < 2) throw InputError(table.where() + ": has less than two places; add some");
  if (*std::max_element(section.speeds.begin(), section.speeds.end()) == 0)
    throw InputError(table.where() + ": all speeds are 0; give the speeds of the water");
  if (!in_space) section.across.clear();
  return section;
}

}  // namespace thalweg
