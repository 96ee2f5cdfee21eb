#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/io/ranged_particle_file.hpp"
#include "common/particle_source.hpp"
#include "common/particles.hpp"
#include "common/run_folder.hpp"
#include "solver/program/run_counts.hpp"

namespace thalweg {

/// A checkpoint: the particles with all that a restart needs, the case they belong to (case_text()), and what the run
/// has cost so far.
struct Checkpoint {
  ParticleSet particles;
  std::string case_text;
  RunCounts counts;
};

/// Writes the run's checkpoint, whole or not at all; the one before the last gives way to the last. Throws RunError.
void write_checkpoint(const RunFolder& run, Checkpoint checkpoint);

/// The same of particles that `file`, which is that of run.checkpoint(), has range by range; `frame` is what it holds beside them,
/// without the case and the counts.
void finish_checkpoint(RangedParticleFile& file, ParticleFileFrame frame, const std::string& case_text,
                       const RunCounts& counts);
/// The file of a checkpoint that is written range by range.
std::unique_ptr<RangedParticleFile> begin_checkpoint(const RunFolder& run);

/// Throws InputError for a file that is no checkpoint, is damaged, or lacks an array or particles it was written with.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// The same, but for the particles, which are left to `source`: the checkpoint has info and facts. Where the file cannot be read
/// range by range it has the particles, and there is no source.
Checkpoint open_checkpoint(const std::filesystem::path& file, std::unique_ptr<ParticleSource>& source);

}  // namespace thalweg
