#include "solver/backend/cuda.cuh"
#include "solver/core.hpp"

template class thalweg::SimulationOn<3, thalweg::Cuda>;
