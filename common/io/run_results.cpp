#include "common/io/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// The series of a run; empty if it is missing or cannot be read.
std::vector<SeriesEntry> known_series(const RunFolder& run) {
  try {
    if (fs::exists(run.snapshot_series())) return read_series(run.snapshot_series());
  } catch (const InputError&) {  // damaged: the snapshots themselves know their times
  }
  return {};
}

/// The snapshots in the folder, by the times they hold. One that cannot be read is left out.
std::vector<SeriesEntry> series_of_files(const RunFolder& run) {
  std::vector<SeriesEntry> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(run.snapshots(), ignored)) {
    if (entry.path().extension() != ".vtp" || entry.path().filename().string().starts_with('.')) continue;
    try {
      found.push_back({read_particle_info(entry.path()).time, run.snapshots().filename() / entry.path().filename()});
    } catch (const InputError&) {  // cut off or damaged
    }
  }
  std::sort(found.begin(), found.end(), [](const SeriesEntry& a, const SeriesEntry& b) { return a.file < b.file; });
  // Of a run that was continued from an earlier checkpoint, files of a later time lie behind.
  std::vector<SeriesEntry> rising;
  for (const SeriesEntry& entry : found) {
    if (rising.empty() || entry.time > rising.back().time) rising.push_back(entry);
  }
  return rising;
}

}  // namespace

std::optional<double> time_reached(const RunFolder& run) {
  double reached = 0;
  std::vector<SeriesEntry> series = known_series(run);
  if (series.empty()) series = series_of_files(run);
  if (!series.empty()) reached = series.back().time;
  for (const fs::path& file : {run.checkpoint(), run.previous_checkpoint()}) {
    try {
      if (fs::exists(file)) reached = std::max(reached, read_particle_info(file).time);
    } catch (const InputError&) {  // damaged: the snapshots tell
    }
  }
  return reached > 0 ? std::make_optional(reached) : std::nullopt;
}

std::string summary_json(const RunFolder& run) {
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  if (!fs::exists(run.summary())) return summary.dump();
  const CsvTable table = CsvTable::read(run.summary());
  const auto names = table.texts("quantity");
  const auto values = table.texts("value");
  const auto units = table.texts("unit");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    nlohmann::ordered_json entry;
    double number = 0;
    const char* end = values[row].data() + values[row].size();
    const auto [rest, problem] = std::from_chars(values[row].data(), end, number);
    const bool is_number = problem == std::errc() && rest == end && !units[row].empty();
    entry["value"] = is_number ? nlohmann::ordered_json(number) : nlohmann::ordered_json(values[row]);
    if (!units[row].empty()) entry["unit"] = units[row];
    summary[names[row]] = entry;
  }
  return summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

void refuse_to_replace(const RunFolder& run, const std::string& cure) {
  if (const auto reached = time_reached(run)) {
    throw InputError(fmt::format("{}: holds a run up to t = {:.6g} s; {}", run.root.string(), *reached, cure));
  }
}

void remove_results(const RunFolder& run) {
  std::error_code ignored;
  for (const fs::path& file : {run.snapshot_series(), run.checkpoint(), run.previous_checkpoint(), run.diverged(),
                               run.history(), run.excluded(), run.gauges(), run.timing(), run.summary()}) {
    fs::remove(file, ignored);
  }
  for (const auto& old : fs::directory_iterator(run.snapshots(), ignored)) {
    if (old.path().extension() == ".vtp") fs::remove(old.path(), ignored);
  }
}

std::vector<SeriesEntry> snapshots_until(const RunFolder& run, double time) {
  std::vector<SeriesEntry> series = known_series(run);
  if (series.empty()) series = series_of_files(run);
  std::error_code ignored;
  std::erase_if(series, [&](const SeriesEntry& e) { return e.time > time || !fs::exists(run.root / e.file, ignored); });
  return series;
}

}  // namespace thalweg
