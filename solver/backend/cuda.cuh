#pragma once

#include <cuda_runtime.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include <cstdint>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_reduce.cuh>
#include <cub/device/device_scan.cuh>
#include <cub/device/device_select.cuh>

#include "solver/backend/cuda_errors.cuh"
#include "solver/backend/gpu.hpp"

namespace thalweg {

/// body(i) for the thread's own i.
template <class Body>
__global__ void __launch_bounds__(128) run_body(Index n, Body body) {
  const Index i = blockIdx.x * 128 + threadIdx.x;
  if (i < n) body(i);
}

/// Gpu's Runtime (solver/backend/gpu.hpp) on the first CUDA device. All work goes to one stream, in order; memory comes
/// from the stream's pool, which keeps what it was given back.
struct CudaRuntime {
  static cudaStream_t stream() { return memory().stream; }

  static void* allocate(std::size_t bytes) {
    void* p = nullptr;
    check_cuda(cudaMallocAsync(&p, bytes, stream()), "allocating memory");
    return p;
  }
  static void release(void* p) noexcept {
    if (p != nullptr) cudaFreeAsync(p, stream());  // nothing to be done about a failure in a destructor
  }
  static void copy_to_device(void* to, const void* from, std::size_t bytes) {
    copy(to, from, bytes, cudaMemcpyHostToDevice);
    wait();
  }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) {
    copy(to, from, bytes, cudaMemcpyDeviceToHost);
    wait();
  }
  static void copy_on_device(void* to, const void* from, std::size_t bytes) {
    copy(to, from, bytes, cudaMemcpyDeviceToDevice);
  }
  /// Until all work so far is done; errors of kernels come to light here.
  static void wait() { check_cuda(cudaStreamSynchronize(stream()), "computing on the GPU"); }

  __host__ __device__ static void atomic_add(std::int64_t* counter, std::int64_t amount) {
#ifdef __CUDA_ARCH__
    atomicAdd(reinterpret_cast<unsigned long long*>(counter), static_cast<unsigned long long>(amount));
#else
    *counter += amount;
#endif
  }

  template <class Body>
  static void launch(Index n, const Body& body) {
    if (n == 0) return;
    run_body<<<(n + 127) / 128, 128, 0, stream()>>>(n, body);
    check_cuda(cudaGetLastError(), "starting a kernel");
  }

  template <class T, class Of, class Combine>
  static T reduce(Index n, const T& start, const Of& of, const Combine& combine) {
    const auto values = thrust::make_transform_iterator(thrust::make_counting_iterator(Index{0}), of);
    return with_result<T>([&](T* result) {
      with_scratch([&](void* scratch, std::size_t& bytes) {
        return cub::DeviceReduce::Reduce(scratch, bytes, values, result, static_cast<int>(n), combine, start, stream());
      });
    });
  }

  /// offsets: n + 1 entries, the first 0.
  static void scan(const Index* counts, Index n, Index* offsets) {
    check_cuda(cudaMemsetAsync(offsets, 0, sizeof(Index), stream()), "clearing memory");
    with_scratch([&](void* scratch, std::size_t& bytes) {
      return cub::DeviceScan::InclusiveSum(scratch, bytes, counts, offsets + 1, static_cast<int>(n), stream());
    });
  }

  template <class Keep>
  static Index select(Index n, const Keep& keep, Index* kept) {
    return with_result<Index>([&](Index* count) {
      with_scratch([&](void* scratch, std::size_t& bytes) {
        return cub::DeviceSelect::If(scratch, bytes, thrust::make_counting_iterator(Index{0}), kept, count,
                                     static_cast<int>(n), keep, stream());
      });
    });
  }

  static void sort(std::uint64_t* key, Index* order, Index n) {
    DeviceBuffer<std::uint64_t, CudaRuntime> other_key;
    DeviceBuffer<Index, CudaRuntime> other_order;
    other_key.resize(n);
    other_order.resize(n);
    cub::DoubleBuffer<std::uint64_t> keys(key, other_key.data());
    cub::DoubleBuffer<Index> orders(order, other_order.data());
    with_scratch([&](void* scratch, std::size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys, orders, static_cast<int>(n), 0, 64, stream());
    });
    if (keys.Current() != key) copy_on_device(key, keys.Current(), n * sizeof(std::uint64_t));
    if (orders.Current() != order) copy_on_device(order, orders.Current(), n * sizeof(Index));
  }

 private:
  static constexpr std::size_t largest_result = 256;
  struct Memory {
    cudaStream_t stream = nullptr;
    void* result = nullptr;          // on the device
    void* result_on_host = nullptr;  // page-locked

    Memory() {
      check_cuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "starting");
      check_cuda(cudaMalloc(&result, largest_result), "allocating memory");
      check_cuda(cudaMallocHost(&result_on_host, largest_result), "allocating page-locked memory");
      int device = 0;
      cudaMemPool_t pool = nullptr;
      std::uint64_t keep_all = UINT64_MAX;
      check_cuda(cudaGetDevice(&device), "starting");
      check_cuda(cudaDeviceGetDefaultMemPool(&pool, device), "starting");
      check_cuda(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &keep_all), "starting");
    }
  };
  /// Made at the first use, and left to the end of the process.
  static const Memory& memory() {
    static const auto* made = new Memory;
    return *made;
  }

  static void copy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
    if (bytes > 0) check_cuda(cudaMemcpyAsync(to, from, bytes, kind, stream()), "copying memory");
  }

  /// Runs work(where), which leaves a T there, and brings it to the host.
  template <class T, class Work>
  static T with_result(const Work& work) {
    static_assert(sizeof(T) <= largest_result && std::is_trivially_copyable_v<T>);
    work(static_cast<T*>(memory().result));
    copy(memory().result_on_host, memory().result, sizeof(T), cudaMemcpyDeviceToHost);
    wait();
    return *static_cast<const T*>(memory().result_on_host);
  }

  /// CUB's way: asked without scratch memory it says how much it needs.
  template <class Work>
  static void with_scratch(const Work& work) {
    std::size_t bytes = 0;
    check_cuda(work(nullptr, bytes), "preparing");
    DeviceBuffer<char, CudaRuntime> scratch;
    scratch.resize(bytes == 0 ? 1 : bytes);
    check_cuda(work(scratch.data(), bytes), "starting a kernel");
  }
};

using Cuda = Gpu<CudaRuntime>;

}  // namespace thalweg
