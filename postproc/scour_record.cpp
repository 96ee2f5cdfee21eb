#include "postproc/scour_record.hpp"

#include <cmath>

#include "case/models/surface_bed.hpp"
#include "common/csv.hpp"

namespace thalweg {

ScourRecord read_scour(const Case& of, const std::filesystem::path& history) {
  ScourRecord record;
  if (!models::SurfaceBedOfCase::is_on(of) || !std::filesystem::exists(history)) return record;
  const CsvTable table = CsvTable::read(history, LastLine::may_be_cut);
  const std::vector<double> time = table.numbers("bed_time", "s");
  const std::vector<double> depth = table.numbers("bed_scour", "m");
  for (std::size_t i = 0; i < time.size(); ++i) {
    // Rows between two bed steps say the same again.
    if (record.time.empty() ? time[i] > 0 : time[i] > record.time.back()) {
      record.time.push_back(time[i]);
      record.depth.push_back(depth[i]);
    }
  }
  if (record.time.empty()) return record;
  record.at[0] = table.numbers("bed_scour_x", "m").back();
  record.at[1] = table.numbers("bed_scour_y", "m").back();
  record.water_time = table.numbers("time", "s").back();
  record.fed = table.numbers("bed_fed", "m^3").back();
  record.left = table.numbers("bed_left", "m^3").back();
  record.steps = std::lround(table.numbers("bed_steps", "-").back());
  record.unsettled = std::lround(table.numbers("bed_unsettled", "-").back());
  record.fit = fit_equilibrium(record.time, record.depth);
  return record;
}

void write_scour(const std::filesystem::path& file, const ScourRecord& record) {
  const bool fitted = record.fit.has_reached();
  std::vector<CsvColumn> columns{{"time", "s"}, {"depth", "m"}};
  if (fitted) columns.push_back({"fit", "m"});
  CsvTable table(columns);
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
