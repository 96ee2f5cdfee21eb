#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "case/case.hpp"
#include "common/particle_source.hpp"
#include "common/particles.hpp"
#include "common/run_folder.hpp"
#include "solver/program/run.hpp"
#include "solver/program/run_counts.hpp"

namespace thalweg {

/// The start of a run: the scene as gencase has filled it, or a checkpoint of it.
struct RunStart {
  Case scene;
  std::filesystem::path file;  // of the particles
  ParticleSet particles;       // where there is a source: info and facts
  std::unique_ptr<ParticleSource> source{};
  RunCounts counts{};
  bool continued = false;
  double wall_speed = 0;  // the largest until the end of the case [m/s]

  [[nodiscard]] std::uint64_t size() const { return source != nullptr ? source->size() : particles.size(); }
};

/// Throws InputError if gencase has not filled the folder.
void require_filled(const RunFolder& run);

/// The case of a run as gencase has resolved it, with what the options change. Throws InputError.
Case read_scene(const RunOptions& options);

/// Reads the case and the particles of a run. Throws InputError for what cannot be a start (start_check.hpp), and for a
/// checkpoint of another case (restart_check.hpp). In a benchmark, which keeps no results, any case may go on from a
/// checkpoint.
RunStart read_run(const RunOptions& options);

}  // namespace thalweg
