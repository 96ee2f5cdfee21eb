#pragma once

#include "solver/backend/cuda.cuh"
#include "solver/core.hpp"

// The simulation on a CUDA device is compiled once per dimension (core_cuda_2d.cu, core_cuda_3d.cu), side by side.
namespace thalweg {

extern template class SimulationOn<2, Cuda>;
extern template class SimulationOn<3, Cuda>;

}  // namespace thalweg
