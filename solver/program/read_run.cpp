#include "solver/program/read_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <optional>
#include <utility>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/ranged_particle_reader.hpp"
#include "common/units.hpp"
#include "solver/program/checkpoint_file.hpp"
#include "solver/program/follow_run.hpp"
#include "solver/program/restart_check.hpp"
#include "solver/program/start_check.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* latest = "latest";

/// A checkpoint and the file it stands in.
struct Found {
  fs::path file;
  Checkpoint checkpoint;
  std::unique_ptr<ParticleSource> source{};  // of its particles, if they are read range by range
};

Found open_or_read(const fs::path& file, bool in_ranges) {
  Found found{file, {}};
  found.checkpoint = in_ranges ? open_checkpoint(file, found.source) : read_checkpoint(file);
  return found;
}

/// The last checkpoint of a run that is whole; nothing if it has none yet. Throws InputError if none of them is whole.
std::optional<Found> latest_checkpoint(const RunFolder& run, bool in_ranges) {
  std::optional<InputError> problem;
  for (const fs::path& file : {run.checkpoint(), run.previous_checkpoint()}) {
    if (!fs::exists(file)) continue;
    try {
      Found found = open_or_read(file, in_ranges);
      if (problem) spdlog::warn("{}; going on from {}", problem->what(), file.string());
      return found;
    } catch (const InputError& error) {
      if (!problem) problem.emplace(error);
    }
  }
  if (problem) throw InputError(*problem);
  return std::nullopt;
}

std::optional<Found> find_checkpoint(const RunOptions& options, bool in_ranges) {
  if (options.restart.empty()) return std::nullopt;
  if (options.restart != latest) return open_or_read(options.restart, in_ranges);
  auto found = latest_checkpoint(RunFolder{options.folder}, in_ranges);
  if (!found) {
    spdlog::info("{}: no checkpoint yet; from the start", options.folder.string());
  } else {
    spdlog::info("continuing from {} at t = {:.6g} s", found->file.string(), found->checkpoint.particles.info.time);
  }
  return found;
}

void read_filled(const fs::path& file, bool in_ranges, RunStart& start) {
  start.file = file;
  auto reader = in_ranges ? RangedParticleReader::open(file) : std::nullopt;
  if (!reader) {
    start.particles = read_particles(file);
    return;
  }
  start.particles = reader->frame();
  start.source = std::make_unique<RangedParticleReader>(std::move(*reader));
}

}  // namespace

void require_filled(const RunFolder& run) {
  if (fs::exists(run.resolved_case())) return;
  throw InputError(fmt::format("{}: not there; fill the scene first: thalweg gencase CASE --out {}",
                               run.resolved_case().string(), run.root.string()));
}

Case read_scene(const RunOptions& options) {
  Case c = read_case(RunFolder{options.folder}.resolved_case(), options.overrides);
  if (options.until.empty()) return c;
  try {
    c.output.end = parse_quantity(options.until, "s");
  } catch (const std::invalid_argument& e) {
    throw InputError("--until " + options.until + ": " + e.what());
  }
  return c;
}

RunStart read_run(const RunOptions& options) {
  RunStart start{read_scene(options), {}, {}};
  const bool in_ranges = deals_in_ranges(start.scene, start_options(options));
  if (std::optional<Found> found = find_checkpoint(options, in_ranges)) {
    if (options.benchmark == 0) {
      check_restart(found->file, found->checkpoint, start.scene, options.restart_anyway);
      start.counts = found->checkpoint.counts;
      ++start.counts.restarts;
    }
    start.file = found->file;
    start.particles = std::move(found->checkpoint.particles);
    start.source = std::move(found->source);
    start.continued = true;
  } else {
    read_filled(RunFolder{options.folder}.particles(), in_ranges, start);
  }
  if (start.source != nullptr) {
    start.wall_speed = check_start(*start.source, start.file, start.scene);
  } else {
    check_start(start.particles, start.file, start.scene);
    start.wall_speed = largest_wall_speed(start.scene, start.particles);
  }
  if (start.particles.info.time >= start.scene.output.end) {
    throw InputError(fmt::format(
        "the {} is at t = {:.6g} s and the run ends at {:.6g} s; give a later end with --until",
        start.continued ? "checkpoint" : "filled scene", start.particles.info.time, start.scene.output.end));
  }
  return start;
}

}  // namespace thalweg
