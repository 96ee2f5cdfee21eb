#include "postproc/scour_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/models/surface_bed.hpp"
#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/units.hpp"

namespace thalweg {

ScourRecord read_scour(const Case& of, const std::filesystem::path& history) {
  ScourRecord record;
  if (!models::SurfaceBedOfCase::is_on(of) || !std::filesystem::exists(history)) return record;
  const CsvTable table = CsvTable::read(history, LastLine::may_be_cut);
  const std::vector<double> time = table.numbers("bed_time", "s");
  const std::vector<double> depth = table.numbers("bed_scour", "m");
  const std::vector<double> x = table.numbers("bed_scour_x", "m");
  const std::vector<double> y = table.numbers("bed_scour_y", "m");
  const std::vector<double> water = table.numbers("time", "s");
  for (std::size_t i = 0; i < time.size(); ++i) {
    // Rows between two bed steps say the same again.
    if (record.time.empty() ? time[i] > 0 : time[i] > record.time.back()) {
      record.time.push_back(time[i]);
      record.depth.push_back(depth[i]);
      record.x.push_back(x[i]);
      record.y.push_back(y[i]);
      record.water.push_back(water[i]);
    }
  }
  if (record.time.empty()) return record;
  record.water_time = water.back();
  record.fed = table.numbers("bed_fed", "m^3").back();
  record.left = table.numbers("bed_left", "m^3").back();
  record.steps = std::lround(table.numbers("bed_steps", "-").back());
  record.unsettled = std::lround(table.numbers("bed_unsettled", "-").back());
  record.fit = fit_equilibrium(record.time, record.depth);
  return record;
}

double scour_at(const ScourRecord& record, double time) {
  double time_before = 0;
  double depth_before = 0;
  for (std::size_t n = 0; n < record.time.size(); ++n) {
    if (record.time[n] >= time) {
      const double share = (time - time_before) / (record.time[n] - time_before);
      return depth_before + share * (record.depth[n] - depth_before);
    }
    time_before = record.time[n];
    depth_before = record.depth[n];
  }
  return depth_before;
}

double bed_time_at(const ScourRecord& record, double time) {
  double bed_time = 0;
  const double latest = time * (1 + 1e-7) + 1e-9;  // history.csv has nine digits
  for (std::size_t n = 0; n < record.time.size() && record.water[n] <= latest; ++n) bed_time = record.time[n];
  return bed_time;
}

std::vector<ScourCheck> read_scour_checks(const RunFolder& run, const ScourRecord& main) {
  std::vector<ScourCheck> checks;
  if (main.time.empty()) return checks;
  for (const bool slower : {true, false}) {
    for (const int times : {2, 4, 8}) {
      const RunFolder beside = slower ? run.slower(times) : run.coarser(times);
      if (!std::filesystem::exists(beside.resolved_case())) continue;
      const Case of = read_case(beside.resolved_case());
      ScourCheck check;
      check.label = slower ? fmt::format("factor {:g}", of.surface_bed.factor)
                           : "spacing " + format_quantity(of.numerics.spacing, "m");
      check.of_spacing = !slower;
      check.record = read_scour(of, beside.history());
      if (check.record.time.empty()) continue;
      check.time = std::min(main.time.back(), check.record.time.back());
      check.depth = scour_at(check.record, check.time);
      check.of_main = scour_at(main, check.time);
      checks.push_back(std::move(check));
    }
  }
  return checks;
}

void write_scour(const std::filesystem::path& file, const ScourRecord& record) {
  const bool fitted = record.fit.has_reached();
  std::vector<CsvColumn> columns{{"time", "s"}, {"depth", "m"}};
  if (fitted) columns.push_back({"fit", "m"});
  CsvTable table(columns);
  table.add_row(fitted ? std::vector<std::string>{"0", "0", "0"} : std::vector<std::string>{"0", "0"});
  for (std::size_t row = 0; row < record.time.size(); ++row) {
    std::vector<std::string> cells{csv_number(record.time[row]), csv_number(record.depth[row])};
    if (fitted) {
      const double grown = 1 - std::exp(-record.time[row] / record.fit.time_scale);
      cells.push_back(csv_number(record.fit.equilibrium * grown));
    }
    table.add_row(std::move(cells));
  }
  table.write(file);
}

}  // namespace thalweg
