#include "solver/backend/cuda.cuh"
#include "solver/core.hpp"

template class thalweg::SimulationOn<2, thalweg::Cuda>;
