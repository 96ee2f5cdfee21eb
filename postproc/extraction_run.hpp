#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/case.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "common/run_folder.hpp"
#include "postproc/profile_set.hpp"

namespace thalweg {

struct FrontSample {
  double time = 0;   // [s]
  double front = 0;  // [m] NaN without water
};

/// What one pass over a run's snapshots gave.
struct ExtractionRun {
  std::vector<TimedProfile> written;    // at the case's compare.times
  std::vector<FrontSample> fronts;      // all snapshots
  std::optional<TimedProfile> initial;  // of the first snapshot
  std::filesystem::path last_snapshot;  // the last one that could be read
  double last_time = 0;                 // [s]
  ParticleFileInfo info;                // of the last one
  double plane_y = 0;                   // [m]
  std::string rest_criterion;           // in words: which sediment counts as resting
  std::vector<std::string> warnings;
  bool damaged = false;  // part of the run could not be read or a time asked for is missing
};

/// Sediment slower than this rests (deposits only, where the solver gives State): a twentieth of sqrt(g d50) [m/s], the
/// speed scale
/// of a grain; about 9 mm/s for the Louvain grains. Below it lie creep and noise of particles at rest (about 1 mm/s),
/// above it moves what a camera sees moving.
double rest_speed_of(const Case& resolved);

/// Reads the snapshots one at a time, writes <out>/profiles/t0.250.csv … and front.csv. A snapshot that cannot be read
/// is named in the warnings and skipped. Throws InputError without any readable snapshot.
ExtractionRun extract_run(const RunFolder& run, const Case& resolved);

}  // namespace thalweg
