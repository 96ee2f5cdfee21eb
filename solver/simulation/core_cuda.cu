// The core module for CUDA devices; see make_simulation.cpp for how it is chosen.
#include "solver/backend/cuda_errors.cuh"
#include "solver/simulation/core_cuda.cuh"

#define THALWEG_EXPORT extern "C" __attribute__((visibility("default")))

/// The caller owns the result.
THALWEG_EXPORT thalweg::Simulation* thalweg_make_simulation(const thalweg::SimulationInput* input) {
  return std::visit([&](const auto& scene) { return thalweg::make_on_cuda(scene, *input); }, input->scene);
}

/// Takes one of this machine's devices, of which there are so many; ranks beyond their number share them.
THALWEG_EXPORT void thalweg_choose_device(int place) { thalweg::choose_cuda_device(place); }

/// Writes the 16 bytes by which ranks know whether they share the chosen device.
THALWEG_EXPORT void thalweg_name_device(std::uint8_t* name) { thalweg::name_cuda_device(name); }

/// Why the CUDA device cannot be used here, or an empty text.
THALWEG_EXPORT const char* thalweg_device_problem() {
  static const std::string problem = thalweg::cuda_problem();
  return problem.c_str();
}

/// Memory of the device that is free [bytes].
THALWEG_EXPORT double thalweg_device_memory() { return thalweg::free_cuda_memory(); }
