#pragma once

#include "solver/simulation/input.hpp"

// The simulation on a CUDA device is compiled once per dimension, side by side.
namespace thalweg {

Simulation* make_on_cuda(const Scene<2>& scene, const SimulationInput& input);  // core_cuda_2d.cu
Simulation* make_on_cuda(const Scene<3>& scene, const SimulationInput& input);  // core_cuda_3d.cu

}  // namespace thalweg
