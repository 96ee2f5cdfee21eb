#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/packed_particles.hpp"
#include "common/particles.hpp"
#include "common/ranks.hpp"
#include "solver/state/report.hpp"
#include "solver/timing.hpp"

namespace thalweg {

/// Sizes worth knowing before and after a run.
struct SimulationFacts {
  std::int64_t particles = 0;
  std::int64_t fluid_particles = 0;
  std::int64_t list_rebuilds = 0;
  std::int64_t fixed_launches = 0;       // steps whose launches on a GPU are known before the step
  std::int64_t repeated_launches = 0;    // of these, those with the launches of the step before
  double list_entries_per_particle = 0;  // with skin, sharing and padding
  double neighbours_mean = 0;            // particles within the support of a fluid particle
  double bytes_per_particle = 0;
  int ranks = 1;
  double copies_per_particle = 0;  // of particles that other ranks have
  Traffic sent;                    // by the rank that sent most bytes
  double imbalance = 0;            // time that the slowest rank computes over the mean of all, less 1 [-]
  double waited = 0;               // since the first step, the mean of the ranks [s]
  double waited_for_copies = 0;    // part of it: for fields of copies [s]
  std::string device;              // "OpenMP, AVX-512, 2 threads"
};

/// Name of a fact of the particle sets of one rank among several: how many of its particles are fluid, and stand first;
/// -1 where they are not in order yet (particle_messages.hpp).
inline constexpr const char* own_fluid_fact = "OwnFluid";

/// Contents of a file of particles: what is looked at, or all that a restart needs.
enum class FileContents { snapshot, full_state };

/// The particles that this rank has itself, a range at a time, for files of several ranks.
class OwnRanges {
 public:
  struct Counts {
    std::uint64_t all;
    std::uint64_t fluid;  // of these, which stand first; where they are not in order yet: all
    double farthest;      // the largest coordinate [m]
  };

  virtual ~OwnRanges() = default;
  virtual Counts counts() = 0;
  /// Particles [from, to) as snapshot() or full_state() has them; without info and facts.
  virtual ParticleSet range(FileContents of, std::uint64_t from, std::uint64_t to) = 0;
  /// The facts of snapshot() or full_state(). Called by all ranks.
  virtual std::map<std::string, std::vector<double>> facts_of(FileContents of) = 0;
};

/// The rest of a file, beside packed particles.
struct PackedFrame {
  std::map<std::string, std::vector<double>> facts;
  PositionPrecision precision;
};

/// A running simulation on some device; the run loop (program/run.hpp) knows it only through this.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Sets the physical time at which the next step starts [s], for walls that move; without it, that of the particles
  /// it was made from and the steps since.
  virtual void set_time(double time) = 0;
  /// One step of at most `longest` seconds.
  virtual StepReport advance(double longest) = 0;
  /// Takes out particles that left the domain in the last step, as the next step would.
  virtual std::vector<ExcludedParticle> take_excluded() = 0;
  virtual Totals totals() = 0;
  /// Mass that came in, went out and was lost since the start.
  virtual MassLedger ledger() const = 0;
  /// Mass that passed each opening since the start; empty without openings.
  virtual std::vector<OpeningFlux> openings() const = 0;
  /// The bed, if it is a surface.
  virtual std::optional<BedReport> bed() const = 0;
  /// The bed's time, if it is a surface, else 0 [s].
  virtual double bed_time() const = 0;
  virtual SimulationFacts facts() = 0;
  /// Processor time of the other ranks since they began [s].
  virtual double cpu_seconds_elsewhere() { return 0; }
  virtual const Timing& timing() const = 0;
  virtual Timing& timing() = 0;

  /// All particles as they are now, for looking at; without ParticleSet::info.
  virtual ParticleSet snapshot() = 0;
  /// The same in two parts: the function it returns makes the particles' set, in any thread, while steps go on.
  virtual std::function<ParticleSet()> begin_snapshot() = 0;
  /// Of a snapshot, in the same order, the particles within any of the regions (boxes, infinite where they please); no
  /// others are brought from the device.
  virtual ParticleSet snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) = 0;
  /// All that a restart needs, in the order of the neighbour lists; without ParticleSet::info.
  virtual ParticleSet full_state() = 0;

  virtual OwnRanges& own_ranges() = 0;
  /// Hands the particles of all ranks to `sink` in ranges, which their ranks have packed: no rank holds all of them. `spacing` [m]
  /// decides on the precision of positions in snapshots. What `sink` throws ends it. Nothing is done, and nothing returned, where
  /// all particles lie in this process: snapshot() and full_state() have them.
  virtual std::optional<PackedFrame> pack(FileContents, double /*spacing*/,
                                          const std::function<void(const PackedRange&)>& /*sink*/) {
    return std::nullopt;
  }
};

}  // namespace thalweg
