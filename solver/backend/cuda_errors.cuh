#pragma once

#include <cuda_runtime_api.h>

#include <string>

namespace thalweg {

/// Throws RunError with CUDA's reason and what can be done about it unless status is success.
/// doing: "allocating memory".
void check_cuda(cudaError_t status, const char* doing);

/// Takes device number `place` of this machine's, or begins again with the first behind the last. Before anything is
/// launched. Returns how many there are.
int choose_cuda_device(int place);

/// Why the CUDA device cannot be used, with the cure; empty if it can.
std::string cuda_problem();

/// "NVIDIA H200, 140 GB".
std::string cuda_device_name();

/// Memory of the device that is free [bytes].
double free_cuda_memory();

}  // namespace thalweg
