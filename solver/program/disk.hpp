#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

/// Bytes that the files of a run will take, from the time of `start` on: an estimate that errs to the high side. On several
/// ranks a file's arrays lie beside it while it is written.
double disk_needed(const Case& scene, const ParticleSet& start, bool on_ranks);

/// Says how much a run will write and how much is free, and warns if that is much, or more than there is: a run may be
/// meant to be stopped, and a full disk ends it with all files whole. Throws InputError above the case's disk_limit.
void check_disk(const Case& scene, const RunFolder& run, const ParticleSet& start, bool on_ranks);

}  // namespace thalweg
