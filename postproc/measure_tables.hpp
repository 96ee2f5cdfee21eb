#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/run_folder.hpp"
#include "postproc/snapshot_measures.hpp"

namespace thalweg {

/// A snapshot that has been measured, as progress.csv knows it.
struct MeasuredSnapshot {
  std::string file;     // relative to the run's folder
  std::string version;  // of the file: its size and time of change
  SnapshotMeasures measures;
  std::shared_ptr<const SnapshotProfiles>
      profiles{};  // null if an earlier pass measured it: then they lie in its files
};

/// Size and time of the last change of a file, in words; empty if there is none.
std::string version_of(const std::filesystem::path& file);

/// progress.csv: what has been measured, so that a pass after an interrupted one, or over a run that went on, measures
/// the other snapshots only. `made_with` says what the rows depend on: a file with another one reads as empty, and so
/// does a damaged file.
void write_progress(const std::filesystem::path& file, const std::vector<MeasuredSnapshot>& done,
                    const std::string& made_with, const Case& resolved);
std::vector<MeasuredSnapshot> read_progress(const std::filesystem::path& file, const std::string& made_with,
                                            const Case& resolved);

/// front.csv, series.csv and, where the case has gauges, gauges.csv in profiles/ (docs/file-formats.md); `spacing` [m]
/// of the particles. Throws RunError.
void write_measures(const RunFolder& run, const std::vector<MeasuredSnapshot>& done, const Case& resolved,
                    double spacing);

}  // namespace thalweg
