#pragma once

#include <cuda_runtime_api.h>

#include <cstdint>
#include <string>

namespace thalweg {

/// Throws RunError with CUDA's reason and what can be done about it unless status is success.
/// doing: "allocating memory".
void check_cuda(cudaError_t status, const char* doing);

/// Takes device number `place` of this machine's, or begins again with the first behind the last. Before anything is
/// launched. Returns how many there are.
void choose_cuda_device(int place);

/// Name of the chosen device by which ranks know whether they share it (16 bytes). The number of a device does not say so:
/// launchers that give each rank a GPU of its own show it as the only one.
void name_cuda_device(std::uint8_t* name);

/// Why the CUDA device cannot be used, with the cure; empty if it can.
std::string cuda_problem();

/// "NVIDIA H200, 140 GB".
std::string cuda_device_name();

/// Memory of the device that is free [bytes].
double free_cuda_memory();

}  // namespace thalweg
