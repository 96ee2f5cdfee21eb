#pragma once

#include <memory>
#include <string>

#include "case/case.hpp"
#include "common/particle_source.hpp"
#include "common/ranks.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

/// The device of a simulation, and its options.
struct StartOptions {
  std::string backend = "auto";          // "cuda", "openmp" or "auto" (simulation/input.hpp)
  std::string instruction_set = "auto";  // "avx512", "avx2", "baseline" or "auto"
  int threads = 0;                       // 0: as many as the machine has cores
  bool profile = false;                  // wait for the device after every heading of the timing
  Ranks* ranks = nullptr;                // that compute the scene together, each calling this; nullptr: one
  std::string device_messages = "auto";  // between GPUs of ranks: "host", "mpi", "nccl" or "auto" (message_way.hpp)
};

/// Starts a case from the particles of gencase, or goes on from those of a checkpoint. On several ranks the first one has
/// them and deals them out; the others pass an empty set. Throws InputError for what the solver cannot run
/// (make_scene.hpp) and for a device that cannot be used (input.hpp), on all ranks.
std::unique_ptr<Simulation> start_simulation(const Case& of, const ParticleSet& particles, const StartOptions& options);

/// Particles that the first of several ranks reads range by range.
struct StartSource {
  ParticleSource* particles;
  std::string file;  // where they stand, for messages
};

/// The same with these; the others pass none. Of cases that deals_in_ranges() is true for; two particles with one id or in one
/// place are refused here.
std::unique_ptr<Simulation> start_simulation(const Case& of, const StartSource& source, const StartOptions& options);

/// True if several ranks can start a case so that none holds all particles. A bed that is a surface and the estimate of the memory
/// on GPUs need all of them.
bool deals_in_ranges(const Case& of, const StartOptions& options);

/// A simulation whose particles lie on several ranks: the first rank leads, and what it asks of its simulation the others
/// do with their shares until it is destroyed. `ranks` outlives it.
std::unique_ptr<Simulation> lead(std::unique_ptr<Simulation> share, Ranks& ranks);

/// On any other rank: does with its share what the first asks for, until that is done.
void follow(Simulation& share, Ranks& ranks);

/// Largest speed of the walls among `particles` until the end of the case [m/s]; of an oscillation its peak's.
double largest_wall_speed(const Case& of, const ParticleSet& particles);

}  // namespace thalweg
