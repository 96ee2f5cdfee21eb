#include "common/io/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>

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
