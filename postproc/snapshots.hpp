#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/io/series.hpp"
#include "common/particles.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

/// The snapshots of a run in order of time, with paths that can be opened, and warnings about the way they were found.
struct SnapshotList {
  std::vector<SeriesEntry> entries;
  std::vector<std::string> warnings;  // a missing or damaged series file; a file that cannot be read
  bool damaged = false;               // one of the warnings means that part of the run is lost
};

/// Takes the times from snapshots.pvd or, where that is missing or damaged, from the files in snapshots/.
/// Throws InputError when the run has no snapshot.
SnapshotList find_snapshots(const RunFolder& run);

/// The first snapshot that can be read; the pass over them warns of the others. Throws InputError if there is none.
ParticleSet first_readable(const std::vector<SeriesEntry>& entries);

}  // namespace thalweg
