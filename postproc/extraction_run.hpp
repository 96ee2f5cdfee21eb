#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "common/run_folder.hpp"
#include "postproc/level_map.hpp"
#include "postproc/profile_set.hpp"

namespace thalweg {

struct FrontSample {
  double time = 0;   // [s]
  double front = 0;  // [m] NaN without water
};

/// The change of the whole bed up to one snapshot; nothing without a bed.
struct BalanceSample {
  double time = 0;  // [s]
  std::optional<BedBalance> balance;
};

/// The profile of one snapshot: its value if this pass measured it, otherwise the file that an earlier pass wrote.
struct SnapshotProfile {
  double time = 0;             // [s] as the file's name says it
  std::filesystem::path file;  // in profiles/all or profiles/LINE
  std::optional<Profile> measured;

  /// The value, read from the file if need be. Throws InputError.
  [[nodiscard]] TimedProfile get() const;
};

/// The results of one pass over a run's snapshots.
struct ExtractionRun {
  std::vector<TimedProfile> written;                                // at the case's compare.times or bed_times
  std::vector<FrontSample> fronts;                                  // all snapshots
  std::vector<BalanceSample> balances;                              // all snapshots
  std::optional<TimedProfile> initial;                              // of the first snapshot
  std::vector<SnapshotProfile> along_x;                             // of all snapshots, in order of time
  std::map<std::string, std::vector<SnapshotProfile>> along_lines;  // the same by the names of the lines
  std::filesystem::path last_snapshot;                              // the last one that could be read
  double last_time = 0;                                             // [s]
  ParticleFileInfo info;                                            // of the last one
  double plane_y = 0;                                               // [m]
  std::shared_ptr<const LevelMap> initial_levels;                   // of the first snapshot; null: not measured here
  std::shared_ptr<const LevelMap> last_levels;                      // of the last one; null: not measured here
  std::string rest_criterion;                                       // in words: which sediment counts as resting
  std::size_t reused = 0;                                           // snapshots whose results an earlier pass had left
  std::vector<std::string> warnings;
  bool damaged = false;  // part of the run could not be read or a time asked for is missing
};

/// True if a snapshot has a water front; a scene without water has none.
bool has_front(const ExtractionRun& extraction);

/// Further things to take from the snapshots, besides the case's own lines and gauges.
struct ExtractionOptions {
  std::vector<ProfileLine> lines;
  bool surfaces = true;
};

/// Reads the snapshots, a few at a time as memory and cores allow, and writes what docs/file-formats.md says of
/// profiles/ and surfaces/. The results of an earlier pass with the same settings are kept as they are. A snapshot that
/// cannot be read is named in the warnings and skipped. Throws InputError without any readable snapshot.
ExtractionRun extract_run(const RunFolder& run, const Case& resolved, const ExtractionOptions& options = {});

}  // namespace thalweg
