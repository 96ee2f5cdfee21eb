#include "solver/simulation/start.hpp"

#include <algorithm>
#include <optional>
#include <thread>

#include "case/models/surface_bed.hpp"
#include "common/installation.hpp"
#include "solver/models/moving_walls/make_motions.hpp"
#include "solver/models/openings/make_openings.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/deal_out.hpp"
#include "solver/simulation/make_scene.hpp"
#include "solver/simulation/message_way.hpp"

namespace thalweg {

namespace {

bool may_use_gpus(const StartOptions& options) { return options.backend != "openmp" && !find_core("cuda").empty(); }

bool is_shared(const StartOptions& options) { return options.ranks != nullptr && options.ranks->size() > 1; }

/// Of what is in `input` so far: scene and particles.
std::unique_ptr<Simulation> start_with(const Case& of, SimulationInput& input, const std::optional<Vec3>& lattice_node,
                                       const StartOptions& options) {
  input.threads = options.threads;
  input.profile = options.profile;
  input.ranks = options.ranks;
  input.messages.way = message_way(options.device_messages);
  input.motions = make_motions(of);
  input.openings = make_openings(of, lattice_node);
  input.double_pair_sums = of.numerics.precision == Precision::double_sums;
  if (options.ranks != nullptr) {
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    if (options.threads == 0) input.threads = std::max(1, cores / options.ranks->on_this_machine());
  }
  return make_simulation(input, options.backend, options.instruction_set);
}

std::unique_ptr<Simulation> start_share(const Case& of, const RankStart& share, const StartOptions& options) {
  SimulationInput input;
  input.particles = &share.particles;
  input.scene = share.scene;
  input.surface_bed = share.surface_bed;
  input.first_block = share.first_block;
  input.gpu_memory = share.gpu_memory;
  return start_with(of, input, share.particles.info.lattice_node, options);
}

}  // namespace

std::unique_ptr<Simulation> start_simulation(const Case& of, const ParticleSet& particles,
                                             const StartOptions& options) {
  if (is_shared(options)) {
    return start_share(of, deal_out(of, particles, *options.ranks, may_use_gpus(options)), options);
  }
  SimulationInput input;
  ParticleSet laid;
  const std::optional<Vec3> lattice_node = particles.info.lattice_node;
  input.particles = &particles;
  if (models::SurfaceBedOfCase::is_on(of)) {
    laid = particles;
    input.surface_bed = make_surface_bed(of, laid);
    input.particles = &laid;
    input.scene = make_scene(of, laid);
  } else {
    input.scene = make_scene(of, particles);
  }
  return start_with(of, input, lattice_node, options);
}

std::unique_ptr<Simulation> start_simulation(const Case& of, const StartSource& source, const StartOptions& options) {
  return start_share(of, deal_out_in_ranges(of, source.particles, source.file, *options.ranks), options);
}

bool deals_in_ranges(const Case& of, const StartOptions& options) {
  return is_shared(options) && !may_use_gpus(options) && !models::SurfaceBedOfCase::is_on(of);
}

double largest_wall_speed(const Case& of, const ParticleSet& particles) {
  return largest_wall_speed(make_motions(of), particles, of.output.end);
}

}  // namespace thalweg
