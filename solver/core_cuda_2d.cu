#include "solver/core_cuda.cuh"

#include "solver/backend/cuda.cuh"
#include "solver/core.hpp"

namespace thalweg {

Simulation* make_on_cuda(const Scene<2>& scene, const ParticleSet& from, bool profile) {
  return new SimulationOn<2, Cuda>(Cuda{}, "CUDA, " + cuda_device_name(), scene, from, profile);
}

}  // namespace thalweg
