#include "solver/program/follow_run.hpp"

#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <utility>

#include "common/console.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {

StartOptions start_options(const RunOptions& options) {
  return {options.backend, options.instruction_set, options.threads,
          options.profile, options.ranks,           options.device_messages};
}

void Invitation::send(bool begins) {
  sent_ = true;
  if (ranks_ != nullptr) gather_from(*ranks_, begins ? 1 : 0);
}

std::unique_ptr<Simulation> start(const RunStart& from, const RunOptions& options) {
  if (options.ranks == nullptr) return start_simulation(from.scene, from.particles, start_options(options));
  const bool in_ranges = from.source != nullptr;
  gather_from(*options.ranks, in_ranges ? 1 : 0);
  auto simulation = in_ranges ? start_simulation(from.scene, StartSource{from.source.get(), from.file.string()},
                                                 start_options(options))
                              : start_simulation(from.scene, from.particles, start_options(options));
  gather_from(*options.ranks, 1);  // all have read the files, which this rank may replace from here on
  return lead(std::move(simulation), *options.ranks);
}

Exit follow_run(const RunOptions& options) {
  Ranks& ranks = *options.ranks;
  spdlog::set_level(spdlog::level::off);  // the first rank speaks
  set_verbosity(Verbosity::quiet);
  if (gather_from(ranks, 0).front() == 0) return Exit::done;
  std::unique_ptr<Simulation> share;
  try {
    const Case scene = read_scene(options);
    const bool in_ranges = gather_from(ranks, 0).front() != 0;
    share = in_ranges ? start_simulation(scene, StartSource{}, start_options(options))
                      : start_simulation(scene, ParticleSet(), start_options(options));
  } catch (const InputError&) {
    return Exit::done;  // which the first rank meets, too, and tells
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: rank %d: %s\n", ranks.rank(), error.what());
    ranks.abandon();
  }
  gather_from(ranks, 1);
  follow(*share, ranks);
  return Exit::done;
}

}  // namespace thalweg
