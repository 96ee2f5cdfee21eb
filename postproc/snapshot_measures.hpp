#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/extraction/gauges.hpp"
#include "common/profile.hpp"
#include "postproc/level_map.hpp"
#include "postproc/measure_settings.hpp"
#include "postproc/surfaces.hpp"

namespace thalweg {

/// The numbers of one snapshot, which progress.csv and series.csv hold.
struct SnapshotMeasures {
  double time = 0;                    // [s]
  double front = 0;                   // [m] NaN without water
  std::optional<BedBalance> balance;  // since the first snapshot; nothing without sediment
  GaugeRow gauges;
  std::string rest_criterion;  // in words: which sediment counts as resting
};

/// The curves of one snapshot, rounded as in their files.
struct SnapshotProfiles {
  ParticleFileInfo info;       // of the snapshot
  Profile along_x;             // in 3-D in the plane MeasureSettings::profile.plane_y
  std::vector<Profile> lines;  // in the order of MeasureSettings::lines
};

/// All that is measured in one snapshot.
struct SnapshotResults {
  SnapshotMeasures measures;
  SnapshotProfiles profiles;
  std::vector<Surface> surfaces;  // empty without fluid, and where the settings ask for none
  LevelMap levels;                // of all columns; empty without fluid
};

/// The heights of all columns of a snapshot. Without fluid, an empty map.
LevelMap levels_of(const ParticleSet& particles, const MeasureSettings& settings);

/// Measures a snapshot at `time` [s]; writes nothing. The bed's change counts from `initial`, the levels of the run's
/// first snapshot, or from the snapshot itself if `initial` is null. Throws InputError if the snapshot cannot be
/// measured.
///
/// The particles are classified once for all sums. Profile, lines, surfaces and level gauges have a sum each: in 3-D
/// their nodes differ (half a spacing apart in a plane, a whole one in space, turned into a line's plane), and a gauge
/// sees its surroundings only, as during the run. In 2-D profile and surfaces have nodes in common, but different
/// origins and orders of summation, on which the last digits depend.
SnapshotResults measure(const ParticleSet& particles, double time, const MeasureSettings& settings,
                        const LevelMap* initial);

}  // namespace thalweg
