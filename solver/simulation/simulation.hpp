#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "common/particles.hpp"
#include "solver/passes/diagnostics.hpp"
#include "solver/step.hpp"

namespace thalweg {

/// What one step did, for the run loop.
struct StepReport {
  double dt = 0;  // [s]
  Limiter limiter = Limiter::sound;
  double largest_speed = 0;  // [m/s] before the step
  ViscousResult viscous;
  int pressure_sweeps = 0;
  bool diverged = false;
  std::vector<ExcludedParticle> excluded;
};

/// Sizes worth knowing before and after a run.
struct SimulationFacts {
  std::int64_t particles = 0;
  std::int64_t fluid_particles = 0;
  std::int64_t list_rebuilds = 0;
  double list_entries_per_particle = 0;  // with skin, sharing and padding
  double neighbours_mean = 0;            // list entries of a cluster per fluid particle within the support
  double bytes_per_particle = 0;
  std::string device;  // "OpenMP, AVX-512, 2 threads"
};

using AnyScene = std::variant<Scene<2>, Scene<3>>;

/// A running simulation on some device; the run loop (run.hpp) knows it only through this.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Physical time at which the next step starts [s], for walls that move; without it, that of the particles it was
  /// made from and the steps since.
  virtual void set_time(double time) = 0;
  /// One step of at most `longest` seconds.
  virtual StepReport advance(double longest) = 0;
  /// Takes out particles that left the domain in the last step, as the next step would.
  virtual std::vector<ExcludedParticle> take_excluded() = 0;
  virtual Totals totals() = 0;
  virtual SimulationFacts facts() = 0;
  virtual const Timing& timing() const = 0;
  virtual Timing& timing() = 0;

  /// All particles as they are now, for looking at; without ParticleSet::info.
  virtual ParticleSet snapshot() = 0;
  /// The same in two parts: what it returns makes the particles' set, in any thread, while steps go on.
  virtual std::function<ParticleSet()> begin_snapshot() = 0;
  /// Of a snapshot, in the same order, the particles within any of the regions (boxes, infinite where they please); no
  /// others are brought from the device.
  virtual ParticleSet snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) = 0;
  /// All that a restart needs, in the order of the neighbour lists; without ParticleSet::info.
  virtual ParticleSet full_state() = 0;
};

/// What a core module (one per device and instruction set) is made from.
struct SimulationInput {
  AnyScene scene;
  const ParticleSet* particles = nullptr;  // from gencase, or full_state() of an earlier run
  int threads = 0;                         // 0: as many as the machine has cores
  bool profile = false;                    // wait for the device after every heading of the timing
  std::vector<WallMotion> motions = {};    // of the case (make_motions.hpp)
  bool double_pair_sums = false;           // numerics.precision
};

/// Makes a simulation on the device `backend` names, "cuda" or "openmp", or with "auto" on the first GPU if there is
/// one that can be used; on CPU cores with the widest instruction set this processor has, or the one named ("avx512",
/// "avx2", "baseline"). Pair sums in double are computed on CPU cores only. Throws InputError for a device that is not
/// there, that does not have the precision, or that is too small for the scene.
std::unique_ptr<Simulation> make_simulation(const SimulationInput& input, const std::string& backend,
                                            const std::string& instruction_set);

}  // namespace thalweg
