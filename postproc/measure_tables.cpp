#include "postproc/measure_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <ostream>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// A number of the balance with its column.
struct BalanceColumn {
  CsvColumn column;
  double (*read)(const BedBalance&);
  void (*write)(BedBalance&, double);
};

std::vector<BalanceColumn> balance_columns(int dimension) {
  const std::string volume = dimension == 3 ? "m^3" : "m^2";
  std::vector<BalanceColumn> columns{
      {{"scour", "m"}, [](const BedBalance& b) { return b.scour; }, [](BedBalance& b, double v) { b.scour = v; }},
      {{"scour_x", "m"},
       [](const BedBalance& b) { return b.scour_at.x(); },
       [](BedBalance& b, double v) { b.scour_at.x() = v; }},
      {{"scour_y", "m"},
       [](const BedBalance& b) { return b.scour_at.y(); },
       [](BedBalance& b, double v) { b.scour_at.y() = v; }},
      {{"deposition", "m"},
       [](const BedBalance& b) { return b.deposition; },
       [](BedBalance& b, double v) { b.deposition = v; }},
      {{"deposition_x", "m"},
       [](const BedBalance& b) { return b.deposition_at.x(); },
       [](BedBalance& b, double v) { b.deposition_at.x() = v; }},
      {{"deposition_y", "m"},
       [](const BedBalance& b) { return b.deposition_at.y(); },
       [](BedBalance& b, double v) { b.deposition_at.y() = v; }},
      {{"resting_scour", "m"},
       [](const BedBalance& b) { return b.resting_scour; },
       [](BedBalance& b, double v) { b.resting_scour = v; }},
      {{"resting_scour_x", "m"},
       [](const BedBalance& b) { return b.resting_scour_at.x(); },
       [](BedBalance& b, double v) { b.resting_scour_at.x() = v; }},
      {{"resting_scour_y", "m"},
       [](const BedBalance& b) { return b.resting_scour_at.y(); },
       [](BedBalance& b, double v) { b.resting_scour_at.y() = v; }},
      {{"eroded", volume}, [](const BedBalance& b) { return b.eroded; }, [](BedBalance& b, double v) { b.eroded = v; }},
      {{"deposited", volume},
       [](const BedBalance& b) { return b.deposited; },
       [](BedBalance& b, double v) { b.deposited = v; }},
      {{"sediment_volume", volume},
       [](const BedBalance& b) { return b.sediment_volume; },
       [](BedBalance& b, double v) { b.sediment_volume = v; }}};
  if (dimension == 2) {
    std::erase_if(columns, [](const BalanceColumn& c) { return c.column.name.ends_with("_y"); });
  }
  return columns;
}

std::vector<CsvColumn> series_columns(const Case& resolved) {
  std::vector<CsvColumn> columns{{"time", "s"}, {"front", "m"}};
  if (!resolved.has_sediment()) return columns;
  for (const BalanceColumn& number : balance_columns(resolved.info.dimension)) columns.push_back(number.column);
  return columns;
}

std::vector<std::string> series_cells(const SnapshotMeasures& measures, const Case& resolved) {
  std::vector<std::string> cells{csv_number(measures.time), csv_number(measures.front)};
  if (!resolved.has_sediment()) return cells;
  for (const BalanceColumn& number : balance_columns(resolved.info.dimension)) {
    cells.push_back(measures.balance ? csv_number(number.read(*measures.balance)) : std::string());
  }
  return cells;
}

void append(std::vector<CsvColumn>& to, const std::vector<CsvColumn>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

void write_fronts(const fs::path& file, const std::vector<MeasuredSnapshot>& done, double spacing) {
  CsvTable table({{"time", "s"}, {"front", "m"}});
  table.comments.push_back(
      fmt::format("largest x with more than {:g} m of water over the bed ({:g} of the particle spacing)",
                  least_layer * spacing, least_layer));
  for (const MeasuredSnapshot& snapshot : done) {
    table.add_row({csv_number(snapshot.measures.time), csv_number(snapshot.measures.front)});
  }
  table.write(file);
}

}  // namespace

std::string version_of(const fs::path& file) {
  std::error_code failure;
  const auto size = fs::file_size(file, failure);
  const auto changed = fs::last_write_time(file, failure);
  return failure ? std::string() : fmt::format("{} B at {}", size, changed.time_since_epoch().count());
}

void write_progress(const fs::path& file, const std::vector<MeasuredSnapshot>& done, const std::string& made_with,
                    const Case& resolved) {
  std::vector<CsvColumn> columns{{"snapshot", ""}, {"version", ""}, {"rest_criterion", ""}};
  append(columns, series_columns(resolved));
  append(columns, gauge_columns(resolved));
  columns.push_back({"note", ""});
  CsvTable table(columns);
  table.comments.push_back(made_with);
  for (const MeasuredSnapshot& snapshot : done) {
    std::vector<std::string> cells{snapshot.file, snapshot.version, snapshot.measures.rest_criterion};
    for (std::string& cell : series_cells(snapshot.measures, resolved)) cells.push_back(std::move(cell));
    for (const double value : snapshot.measures.gauges.values) cells.push_back(csv_number(value));
    cells.push_back(fmt::format("{}", fmt::join(snapshot.measures.gauges.notes, "; ")));
    table.add_row(std::move(cells));
  }
  table.write(file);
}

std::vector<MeasuredSnapshot> read_progress(const fs::path& file, const std::string& made_with, const Case& resolved) {
  std::vector<MeasuredSnapshot> done;
  if (!fs::exists(file)) return done;
  try {
    const CsvTable table = CsvTable::read(file);
    if (table.comments != std::vector<std::string>{made_with}) return done;
    const auto numbers = [&](const CsvColumn& column) { return table.numbers(column.name, column.unit); };
    const std::vector<std::string> files = table.texts("snapshot");
    const std::vector<std::string> versions = table.texts("version");
    const std::vector<std::string> criteria = table.texts("rest_criterion");
    const std::vector<std::string> notes = table.texts("note");
    const std::vector<double> times = table.numbers("time", "s");
    const std::vector<double> fronts = table.numbers("front", "m");
    for (std::size_t row = 0; row < table.rows(); ++row) {
      MeasuredSnapshot& snapshot = done.emplace_back();
      snapshot.file = files[row];
      snapshot.version = versions[row];
      snapshot.measures.time = times[row];
      snapshot.measures.front = fronts[row];
      snapshot.measures.rest_criterion = criteria[row];
      if (!notes[row].empty()) snapshot.measures.gauges.notes.push_back(notes[row]);
    }
    for (const CsvColumn& column : gauge_columns(resolved)) {
      const std::vector<double> values = numbers(column);
      for (std::size_t row = 0; row < done.size(); ++row) done[row].measures.gauges.values.push_back(values[row]);
    }
    if (!resolved.has_sediment()) return done;
    for (const BalanceColumn& number : balance_columns(resolved.info.dimension)) {
      const std::vector<double> values = numbers(number.column);
      for (std::size_t row = 0; row < done.size(); ++row) {
        if (std::isnan(values[row])) continue;
        if (!done[row].measures.balance) done[row].measures.balance.emplace();
        number.write(*done[row].measures.balance, values[row]);
      }
    }
    return done;
  } catch (const InputError&) {
    return {};
  }
}

void write_measures(const RunFolder& run, const std::vector<MeasuredSnapshot>& done, const Case& resolved,
                    double spacing) {
  write_fronts(run.profiles() / "front.csv", done, spacing);
  CsvTable series(series_columns(resolved));
  series.comments.emplace_back(
      "one row a snapshot, of the whole bed; scour and deposition: largest fall and rise of the bed (top of the "
      "sediment, moving or not) since the first snapshot; resting_scour: the same of the sediment at rest; eroded and "
      "deposited: volumes between the two beds, pores included");
  for (const MeasuredSnapshot& snapshot : done) series.add_row(series_cells(snapshot.measures, resolved));
  series.write(run.profiles() / "series.csv");

  const fs::path gauges = run.profiles() / "gauges.csv";
  if (resolved.gauges.empty()) {
    fs::remove(gauges);
    return;
  }
  write_whole_text(gauges, [&](std::ostream& to) {
    to << gauge_heading_line(resolved) << '\n';
    for (const MeasuredSnapshot& snapshot : done) {
      to << gauge_line(snapshot.measures.time, snapshot.measures.gauges) << '\n';
    }
  });
}

}  // namespace thalweg
