#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "postproc/snapshot_measures.hpp"

namespace thalweg {

/// A snapshot that has been measured, as progress.csv knows it.
struct MeasuredSnapshot {
  std::string file;     // relative to the run's folder
  std::string version;  // of the file: its size and time of change
  SnapshotMeasures measures;
};

/// Size and time of the last change of a file, in words; empty when there is none.
std::string version_of(const std::filesystem::path& file);

/// progress.csv: what has been measured, so that a pass that was broken off, or a longer run, goes on from there.
/// `made_with` tells whether the rows are worth anything: a file made otherwise reads as empty, and so does a damaged
/// one.
void write_progress(const std::filesystem::path& file, const std::vector<MeasuredSnapshot>& done,
                    const std::string& made_with, const Case& resolved);
std::vector<MeasuredSnapshot> read_progress(const std::filesystem::path& file, const std::string& made_with,
                                            const Case& resolved);

/// series.csv and, where the case has gauges, gauges.csv in profiles/ (docs/file-formats.md). Throws RunError.
void write_measures(const RunFolder& run, const std::vector<MeasuredSnapshot>& done, const Case& resolved);

}  // namespace thalweg
