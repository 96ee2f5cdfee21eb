#include "solver/simulation/start.hpp"

#include <algorithm>
#include <thread>

#include "case/models/surface_bed.hpp"
#include "common/error.hpp"
#include "solver/models/moving_walls/make_motions.hpp"
#include "solver/models/openings/make_openings.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/make_scene.hpp"

namespace thalweg {
namespace {

/// Refuses what does not run on several ranks yet.
void check_for_ranks(const AnyScene& scene) {
  const bool loads_a_bed = std::visit([](const auto& s) { return s.suspended_load.on && !s.surface_bed.on; }, scene);
  if (loads_a_bed) {
    throw InputError(
        "water that carries grains over a bed of particles runs on one rank so far; leave --ranks out, or choose "
        "model.sediment = \"surface\"");
  }
}

}  // namespace

std::unique_ptr<Simulation> start_simulation(const Case& of, const ParticleSet& particles,
                                             const StartOptions& options) {
  SimulationInput input;
  ParticleSet laid;
  input.particles = &particles;
  if (models::SurfaceBedOfCase::is_on(of)) {
    laid = particles;
    input.surface_bed = make_surface_bed(of, laid);
    input.particles = &laid;
  }
  input.scene = make_scene(of, *input.particles);
  input.threads = options.threads;
  input.profile = options.profile;
  input.ranks = options.ranks;
  input.motions = make_motions(of);
  input.openings = make_openings(of, particles.info.lattice_node);
  input.double_pair_sums = of.numerics.precision == Precision::double_sums;
  if (options.ranks != nullptr) {
    check_for_ranks(input.scene);
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    if (options.threads == 0) input.threads = std::max(1, cores / options.ranks->on_this_machine());
  }
  return make_simulation(input, options.backend, options.instruction_set);
}

double largest_wall_speed(const Case& of, const ParticleSet& particles) {
  return largest_wall_speed(make_motions(of), particles, of.output.end);
}

}  // namespace thalweg
