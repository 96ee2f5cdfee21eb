#include "solver/simulation/core_cuda.cuh"

#include "solver/backend/cuda.cuh"
#include "solver/simulation/simulation_on.hpp"

namespace thalweg {

Simulation* make_on_cuda(const Scene<2>& scene, const SimulationInput& input) {
  return new SimulationOn<2, Cuda>(Cuda(input.stores_coefficients), "CUDA, " + cuda_device_name(), scene,
                                   *input.particles, input.profile, input.motions, input.openings, input.surface_bed,
                                   input.ranks, input.first_block, input.messages);
}

}  // namespace thalweg
