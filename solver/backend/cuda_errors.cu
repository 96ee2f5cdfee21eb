#include "solver/backend/cuda_errors.cuh"

#include <cstring>

#include "common/error.hpp"
#include "solver/backend/cuda.cuh"

namespace thalweg {
namespace {

/// "13.0" from CUDA's 13000.
std::string version_text(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

std::string cure_of_driver() {
  int driver = 0;
  int runtime = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  if (driver == 0) return "no NVIDIA driver is installed here; install one, or use --backend openmp";
  return "the driver supports CUDA " + version_text(driver) + ", this build needs " + version_text(runtime) +
         "; install a newer NVIDIA driver, or build with an older CUDA Toolkit";
}

/// The cure of an error, in a user's words; empty if none is known.
std::string cure(cudaError_t status) {
  switch (status) {
    case cudaErrorInsufficientDriver:
    case cudaErrorSystemDriverMismatch:
    case cudaErrorUnsupportedPtxVersion:
      return cure_of_driver();
    case cudaErrorNoDevice:
      return "no NVIDIA GPU is visible; look at nvidia-smi and CUDA_VISIBLE_DEVICES, or use --backend openmp";
    case cudaErrorNoKernelImageForDevice:
    case cudaErrorInvalidDeviceFunction:
      return "this build holds no code for this GPU; configure with -DCMAKE_CUDA_ARCHITECTURES=native on this machine";
    case cudaErrorMemoryAllocation:
      return "the GPU's memory is full; use a larger spacing, or end what else runs on it (nvidia-smi)";
    case cudaErrorDevicesUnavailable:
      return "another process has the GPU for itself; wait for it, or use --backend openmp";
    case cudaErrorIllegalAddress:
    case cudaErrorLaunchFailure:
    case cudaErrorMisalignedAddress:
      return "a defect of the program; run it under compute-sanitizer and report what it says";
    case cudaErrorLaunchTimeout:
      return "a GPU that drives a display stops long kernels; use one that does not, or fewer particles";
    default:
      return "";
  }
}

std::string reason(cudaError_t status) {
  const std::string known = cure(status);
  return std::string(cudaGetErrorString(status)) + (known.empty() ? "" : "; " + known);
}

struct Nothing {
  HOST_DEVICE void operator()(Index) const {}
};

}  // namespace

void check_cuda(cudaError_t status, const char* doing) {
  if (status != cudaSuccess) throw RunError(std::string("CUDA, while ") + doing + ": " + reason(status));
}

void choose_cuda_device(int place) {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) return;  // cuda_problem() says why
  check_cuda(cudaSetDevice(place % devices), "choosing a device");
}

void name_cuda_device(std::uint8_t* name) {
  int device = 0;
  cudaDeviceProp of{};
  check_cuda(cudaGetDevice(&device), "reading the device's name");
  check_cuda(cudaGetDeviceProperties(&of, device), "reading the device's name");
  std::memcpy(name, of.uuid.bytes, sizeof(of.uuid.bytes));
}

std::string cuda_problem() {
  int devices = 0;
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess) return reason(status);
  if (devices == 0) return reason(cudaErrorNoDevice);
  try {
    // The first kernel tells whether there is code for this device.
    CudaRuntime::launch(1, Nothing{}, nullptr);
    CudaRuntime::wait();
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  check_cuda(cudaGetDevice(&device), "asking for the device");
  check_cuda(cudaGetDeviceProperties(&properties, device), "asking for the device");
  return std::string(properties.name) + ", " + std::to_string(properties.totalGlobalMem / 1000000000) + " GB";
}

double free_cuda_memory() {
  std::size_t free = 0;
  std::size_t total = 0;
  check_cuda(cudaMemGetInfo(&free, &total), "asking for the memory");
  return double(free);
}

}  // namespace thalweg
