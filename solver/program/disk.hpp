#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

/// Bytes that the files of a run will take, from the time of `start` on: an estimate that errs to the high side.
double disk_needed(const Case& scene, const ParticleSet& start);

/// Says how much a run will write and how much is free. Throws InputError if it will not fit, warns if little is left.
void check_disk(const Case& scene, const RunFolder& run, const ParticleSet& start);

}  // namespace thalweg
