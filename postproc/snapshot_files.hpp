#pragma once

#include <filesystem>
#include <vector>

#include "common/run_folder.hpp"
#include "postproc/snapshot_measures.hpp"

namespace thalweg {

/// The files with the results of one snapshot (docs/file-formats.md).
struct SnapshotFiles {
  std::filesystem::path profile;             // profiles/all/t0.250.csv
  std::vector<std::filesystem::path> lines;  // profiles/NAME/t0.250.csv, in the order of MeasureSettings::lines
  std::filesystem::path surface_stem;        // surfaces/ with the name's end, "_t0.250"

  /// surfaces/KIND_t0.250.EXTENSION; `extension` with its dot.
  [[nodiscard]] std::filesystem::path surface(SurfaceKind kind, const char* extension) const;
};
SnapshotFiles files_at(double time, const RunFolder& run, const MeasureSettings& settings);

/// Writes the profiles and surfaces of a snapshot, each file whole or not at all. Throws RunError.
void write(const SnapshotResults& results, const RunFolder& run, const MeasureSettings& settings);

}  // namespace thalweg
