#include "solver/simulation/start.hpp"

#include "solver/models/moving_walls/make_motions.hpp"
#include "solver/models/openings/make_openings.hpp"
#include "solver/simulation/make_scene.hpp"

namespace thalweg {

std::unique_ptr<Simulation> start_simulation(const Case& of, const ParticleSet& particles,
                                             const StartOptions& options) {
  SimulationInput input;
  input.scene = make_scene(of, particles);
  input.particles = &particles;
  input.threads = options.threads;
  input.profile = options.profile;
  input.motions = make_motions(of);
  input.openings = make_openings(of);
  input.double_pair_sums = of.numerics.precision == Precision::double_sums;
  return make_simulation(input, options.backend, options.instruction_set);
}

double largest_wall_speed(const Case& of, const ParticleSet& particles) {
  return largest_wall_speed(make_motions(of), particles, of.output.end);
}

}  // namespace thalweg
