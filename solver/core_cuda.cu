// The core module for CUDA devices; see make_simulation.cpp for how it is chosen.
#include "solver/backend/cuda.cuh"
#include "solver/core.hpp"

namespace {

template <int Dim>
thalweg::Simulation* make(const thalweg::Scene<Dim>& scene, const thalweg::SimulationInput& input) {
  return new thalweg::SimulationOn<Dim, thalweg::Cuda>(thalweg::Cuda{}, "CUDA, " + thalweg::cuda_device_name(), scene,
                                                       *input.particles);
}

}  // namespace

/// The caller owns the result.
extern "C" __attribute__((visibility("default"))) thalweg::Simulation* thalweg_make_simulation(
    const thalweg::SimulationInput* input) {
  return std::visit([&](const auto& scene) { return make(scene, *input); }, input->scene);
}

/// Why no CUDA device can be used here, or an empty text.
extern "C" __attribute__((visibility("default"))) const char* thalweg_device_problem() {
  static const std::string problem = thalweg::cuda_problem();
  return problem.c_str();
}
