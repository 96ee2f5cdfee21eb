#include "postproc/opening_records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/csv.hpp"

namespace thalweg {
namespace {

constexpr std::size_t windows = 50;

/// Mean of the numbers of [from, to) that are there; NaN if none is.
double mean(const std::vector<double>& numbers, std::size_t from, std::size_t to) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = from; i < to; ++i) {
    if (!std::isnan(numbers[i])) sum += numbers[i], count += 1;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Slope of the straight line through the points from `first` on: what passes comes particle by particle, and two of the
/// points say little.
double slope(const std::vector<double>& x, const std::vector<double>& y, std::size_t first) {
  const double n = static_cast<double>(x.size() - first);
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = first; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  double along = 0;
  double both = 0;
  for (std::size_t i = first; i < x.size(); ++i) {
    along += (x[i] - mean_x) * (x[i] - mean_x);
    both += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return along > 0 ? both / along : 0;
}

}  // namespace

OpeningRecords read_openings(const Case& of, const std::filesystem::path& history) {
  OpeningRecords records;
  if ((of.inlets.empty() && of.outlets.empty()) || !std::filesystem::exists(history)) return records;
  const CsvTable table = CsvTable::read(history, LastLine::may_be_cut);
  const std::vector<double> time = table.numbers("time", "s");
  constexpr std::size_t fewest = 4;
  if (time.size() < fewest) return records;
  const std::size_t rows_of_window = std::max<std::size_t>(1, (time.size() - 1) / windows);
  const auto add = [&](const std::string& name, bool enters) {
    const std::vector<double> water = table.numbers(name + "_water", "kg");
    const std::vector<double> level = table.numbers(name + "_level", "m");
    const auto rate = [&](std::size_t from, std::size_t to) {
      return (water[to] - water[from]) / (time[to] - time[from]) / of.water.density;
    };
    OpeningRecord record;
    record.name = name;
    record.enters = enters;
    for (std::size_t from = 0; from + rows_of_window < time.size(); from += rows_of_window) {
      record.rate.push_back(rate(from, from + rows_of_window));
      record.level.push_back(mean(level, from, from + rows_of_window));
    }
    record.water = water.back();
    record.sediment = table.numbers(name + "_sediment", "kg").back();
    const std::size_t half = time.size() / 2;
    record.mean_rate = slope(time, water, half) / of.water.density;
    record.mean_level = mean(level, half, time.size());
    records.openings.push_back(std::move(record));
  };
  for (const Inlet& inlet : of.inlets) add(inlet.name, true);
  for (const Outlet& outlet : of.outlets) add(outlet.name, false);
  for (std::size_t from = 0; from + rows_of_window < time.size(); from += rows_of_window) {
    records.time.push_back(0.5 * (time[from] + time[from + rows_of_window]));
  }
  return records;
}

void write_openings(const std::filesystem::path& file, const OpeningRecords& records, int dimension) {
  const std::string unit = dimension == 2 ? "m^2/s" : "m^3/s";
  std::vector<CsvColumn> columns{{"time", "s"}};
  for (const OpeningRecord& opening : records.openings) {
    columns.push_back({opening.name + "_rate", unit});
    columns.push_back({opening.name + "_level", "m"});
  }
  CsvTable table(columns);
  for (std::size_t row = 0; row < records.time.size(); ++row) {
    std::vector<std::string> cells{csv_number(records.time[row])};
    for (const OpeningRecord& opening : records.openings) {
      cells.push_back(csv_number(opening.rate[row]));
      cells.push_back(csv_number(opening.level[row]));
    }
    table.add_row(std::move(cells));
  }
  table.write(file);
}

}  // namespace thalweg
