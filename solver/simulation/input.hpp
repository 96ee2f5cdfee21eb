#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/ranks.hpp"
#include "solver/backend/device_link.hpp"
#include "solver/models/all.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

using AnyScene = std::variant<Scene<2>, Scene<3>>;

/// Memory that a scene takes on a GPU at its peak [bytes], and how many entries its neighbour lists have: estimates from the
/// declarations of its arrays, before anything is allocated (gpu_memory.hpp).
struct GpuMemory {
  double particles = 0;     // of the scene [-]
  double needed = 0;        // without the viscous pair coefficients
  double coefficients = 0;  // more, if they are stored
  double entries = 0;       // of the neighbour lists [-]
};

/// The input of a core module (one per device and instruction set).
struct SimulationInput {
  AnyScene scene;
  const ParticleSet* particles = nullptr;        // from gencase, or full_state() of an earlier run; of a rank its share
  int threads = 0;                               // 0: as many as the machine has cores
  bool profile = false;                          // wait for the device after every heading of the timing
  std::vector<WallMotion> motions = {};          // of the case (models/moving_walls/make_motions.hpp)
  bool double_pair_sums = false;                 // numerics.precision
  std::shared_ptr<Openings> openings = {};       // of the case (models/openings/make_openings.hpp); null without any
  std::shared_ptr<SurfaceBed> surface_bed = {};  // of the case (models/surface_bed/make_surface_bed.hpp); null without
  Ranks* ranks = nullptr;                        // that compute the scene together; nullptr: this process alone
  bool stores_coefficients = false;              // on a GPU: keep the viscous pair coefficients (Gpu)
  std::int64_t first_block = 0;                  // of sums, in which a rank's share begins (deal.hpp)
  std::optional<GpuMemory> gpu_memory = {};      // of a rank's GPU; nothing: estimated from `particles`
  MessageWish messages = {};                     // between the GPUs of ranks
};

/// Makes a simulation on the device `backend` names, "cuda" or "openmp", or with "auto" on a GPU if there is one that can
/// be used and holds the scene (a line says so where it does not); on CPU cores with the widest instruction set this
/// processor has, or the one named ("avx512", "avx2", "baseline"). Several ranks all take a GPU each, or all CPU cores.
/// Pair sums in double are computed on CPU cores only. Throws InputError for a device that is not there, that does not have
/// the precision, or that is too small for the scene.
std::unique_ptr<Simulation> make_simulation(const SimulationInput& input, const std::string& backend,
                                            const std::string& instruction_set);

}  // namespace thalweg
