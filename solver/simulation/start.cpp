#include "solver/simulation/start.hpp"

#include <algorithm>
#include <thread>

#include "case/models/surface_bed.hpp"
#include "solver/models/moving_walls/make_motions.hpp"
#include "solver/models/openings/make_openings.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/make_scene.hpp"

namespace thalweg {

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
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    if (options.threads == 0) input.threads = std::max(1, cores / options.ranks->on_this_machine());
  }
  return make_simulation(input, options.backend, options.instruction_set);
}

double largest_wall_speed(const Case& of, const ParticleSet& particles) {
  return largest_wall_speed(make_motions(of), particles, of.output.end);
}

}  // namespace thalweg
