#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/extraction/gauges.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "common/run_folder.hpp"
#include "postproc/level_map.hpp"

namespace thalweg {

/// What is taken from every snapshot.
struct MeasureSettings {
  Case resolved;
  ExtractionSettings profile;
  std::vector<ProfileLine> lines;
  bool surfaces = true;
};

/// The numbers of one snapshot.
struct SnapshotMeasures {
  double time = 0;                    // [s]
  double front = 0;                   // [m] NaN without water
  std::optional<BedBalance> balance;  // since the first snapshot; nothing without sediment
  GaugeRow gauges;
  std::string rest_criterion;  // in words: which sediment counts as resting
};

/// Sediment slower than this rests (deposits only, where the solver gives State): a twentieth of sqrt(g d50) [m/s], the
/// speed scale
/// of a grain; about 9 mm/s for the Louvain grains. Below it lie creep and noise of particles at rest (about 1 mm/s),
/// above it moves what a camera sees moving.
double rest_speed_of(const Case& resolved);

/// Settings for the case's domain, lines and gauges, with further lines.
MeasureSettings settings_of(const Case& resolved, const std::vector<ProfileLine>& further_lines, bool surfaces);

/// Where the results of one snapshot lie.
struct SnapshotFiles {
  std::filesystem::path profile;             // profiles/all/t0.250.csv
  std::vector<std::filesystem::path> lines;  // profiles/NAME/t0.250.csv
  std::filesystem::path surface_stem;        // surfaces/ with the name's end, "_t0.250"

  [[nodiscard]] std::filesystem::path surface(const char* kind, const char* extension) const;
};
SnapshotFiles files_at(double time, const RunFolder& run, const MeasureSettings& settings);

/// The heights of the first snapshot's columns, from which the bed's change counts. Without fluid, an empty map.
LevelMap initial_levels(const ParticleSet& particles, const MeasureSettings& settings);

/// Measures a snapshot and writes its profiles and surfaces. The bed's change counts from `initial` or, for the first
/// snapshot, which has none, from the snapshot itself, whose heights then come back in `own`. Throws InputError where
/// it cannot be measured, RunError where its results cannot be written.
SnapshotMeasures measure_snapshot(const ParticleSet& particles, double time, const RunFolder& run,
                                  const MeasureSettings& settings, const LevelMap* initial, LevelMap* own = nullptr);

}  // namespace thalweg
