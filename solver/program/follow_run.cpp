#include "solver/program/follow_run.hpp"

#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <utility>

#include "common/console.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

StartOptions start_options(const RunOptions& options) {
  return {options.backend, options.instruction_set, options.threads, options.profile, options.ranks};
}

}  // namespace

void Invitation::send(bool begins) {
  sent_ = true;
  if (ranks_ != nullptr) gather_from(*ranks_, begins ? 1 : 0);
}

std::unique_ptr<Simulation> start(const RunStart& from, const RunOptions& options) {
  auto simulation = start_simulation(from.scene, from.particles, start_options(options));
  if (options.ranks == nullptr) return simulation;
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
    share = start_simulation(read_scene(options), {}, start_options(options));
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
