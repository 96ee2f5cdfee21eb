#include "solver/program/read_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <optional>
#include <utility>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/units.hpp"
#include "solver/program/checkpoint_file.hpp"
#include "solver/program/restart_check.hpp"
#include "solver/program/start_check.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* latest = "latest";

/// A checkpoint and the file it stands in.
struct Found {
  fs::path file;
  Checkpoint checkpoint;
};

/// The last checkpoint of a run that is whole; nothing if it has none yet. Throws InputError if none of them is whole.
std::optional<Found> latest_checkpoint(const RunFolder& run) {
  std::optional<InputError> problem;
  for (const fs::path& file : {run.checkpoint(), run.previous_checkpoint()}) {
    if (!fs::exists(file)) continue;
    try {
      Found found{file, read_checkpoint(file)};
      if (problem) spdlog::warn("{}; going on from {}", problem->what(), file.string());
      return found;
    } catch (const InputError& error) {
      if (!problem) problem.emplace(error);
    }
  }
  if (problem) throw InputError(*problem);
  return std::nullopt;
}

std::optional<Found> find_checkpoint(const RunOptions& options) {
  if (options.restart.empty()) return std::nullopt;
  if (options.restart != latest) return Found{options.restart, read_checkpoint(options.restart)};
  auto found = latest_checkpoint(RunFolder{options.folder});
  if (!found) {
    spdlog::info("{}: no checkpoint yet; from the start", options.folder.string());
  } else {
    spdlog::info("continuing from {} at t = {:.6g} s", found->file.string(), found->checkpoint.particles.info.time);
  }
  return found;
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
  RunStart start{read_scene(options), {}};
  if (std::optional<Found> found = find_checkpoint(options)) {
    if (options.benchmark == 0) {
      check_restart(found->file, found->checkpoint, start.scene, options.restart_anyway);
      start.counts = found->checkpoint.counts;
      ++start.counts.restarts;
    }
    start.particles = std::move(found->checkpoint.particles);
    start.continued = true;
    check_start(start.particles, found->file, start.scene);
  } else {
    const fs::path file = RunFolder{options.folder}.particles();
    start.particles = read_particles(file);
    check_start(start.particles, file, start.scene);
  }
  if (start.particles.info.time >= start.scene.output.end) {
    throw InputError(fmt::format(
        "the {} is at t = {:.6g} s and the run ends at {:.6g} s; give a later end with --until",
        start.continued ? "checkpoint" : "filled scene", start.particles.info.time, start.scene.output.end));
  }
  return start;
}

}  // namespace thalweg
