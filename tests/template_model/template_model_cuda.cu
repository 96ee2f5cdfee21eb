// The template model on a CUDA device: compiled wherever the CUDA Toolkit is, to see that nvcc takes it.
#include "solver/backend/cuda.cuh"
#include "solver/simulation/simulation_on.hpp"

template class thalweg::SimulationOn<2, thalweg::Cuda>;
