#pragma once

#include <cuda_runtime.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include <cstdint>
#include <cstring>
#include <cub/block/block_reduce.cuh>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <cub/device/device_select.cuh>
#include <thread>
#include <type_traits>
#include <utility>

#include "solver/backend/cuda_errors.cuh"
#include "solver/backend/gpu.hpp"

namespace thalweg {

/// body(i) for the thread's own i; nothing where *flag is 0.
template <class Body>
__global__ void __launch_bounds__(128) run_body(Index n, Body body, const int* flag) {
  if (flag != nullptr && *flag == 0) return;
  const Index i = blockIdx.x * 128 + threadIdx.x;
  if (i < n) body(i);
}

/// A team: the 32 threads of a warp (backend/gpu.hpp).
struct CudaTeam {
  static constexpr Index size = 32;
  static constexpr unsigned all = 0xffffffffU;
  template <class T>
  struct PerLane {
    T own;
    __device__ T& operator[](Index) { return own; }
  };
  Index lane;

  template <class What>
  __device__ void each(const What& what) {
    what(lane);
  }
  template <class What>
  __device__ void once(const What& what) {
    if (lane == 0) what();
  }
  template <class What>
  __device__ std::uint32_t ballot(const What& what) {
    return __ballot_sync(all, what(lane));
  }
  template <class What>
  __device__ std::uint32_t any_bits(const What& what) {
    return __reduce_or_sync(all, what(lane));
  }
  template <class T>
  __device__ T get(const PerLane<T>& of, Index from) {
    return __shfl_sync(all, of.own, static_cast<int>(from));
  }
};

/// body(i, team) for the team's own i; nothing where *flag is 0.
template <class Body>
__global__ void __launch_bounds__(128) run_team(Index n, Body body, const int* flag) {
  if (flag != nullptr && *flag == 0) return;
  const Index i = blockIdx.x * 4 + threadIdx.x / CudaTeam::size;
  if (i >= n) return;  // all threads of a team
  CudaTeam team{threadIdx.x % CudaTeam::size};
  body(i, team);
}

/// combine() of of(i) over the block's i, every gridDim-th 128 of them: in an order that n alone decides, so that sums
/// are the same in every run.
template <class T, class Of, class Combine>
__global__ void __launch_bounds__(128)
    reduce_blocks(Index n, T start, Of of, Combine combine, T* partial, const int* flag) {
  using BlockReduce = cub::BlockReduce<T, 128>;
  __shared__ typename BlockReduce::TempStorage storage;
  if (flag != nullptr && *flag == 0) return;
  T sum = start;
  for (Index i = blockIdx.x * 128 + threadIdx.x; i < n; i += gridDim.x * 128) sum = combine(sum, of(i));
  const T total = BlockReduce(storage).Reduce(sum, combine);
  if (threadIdx.x == 0) partial[blockIdx.x] = total;
}

/// combine() of every `share` entries of what the blocks found.
template <class T, class Combine>
__global__ void __launch_bounds__(256) combine_blocks(Index blocks, Index share, T start, Combine combine,
                                                      const T* partial, T* combined, const int* flag) {
  using BlockReduce = cub::BlockReduce<T, 256>;
  __shared__ typename BlockReduce::TempStorage storage;
  if (flag != nullptr && *flag == 0) return;
  const Index from = blockIdx.x * share;
  const Index to = from + share < blocks ? from + share : blocks;
  T sum = start;
  for (Index b = from + threadIdx.x; b < to; b += 256) sum = combine(sum, partial[b]);
  const T total = BlockReduce(storage).Reduce(sum, combine);
  if (threadIdx.x == 0) combined[blockIdx.x] = total;
}

/// then() of what the blocks found.
template <class T, class Combine, class Then>
__global__ void __launch_bounds__(256)
    finish_reduction(Index blocks, T start, Combine combine, const T* partial, Then then, const int* flag) {
  using BlockReduce = cub::BlockReduce<T, 256>;
  __shared__ typename BlockReduce::TempStorage storage;
  if (flag != nullptr && *flag == 0) return;
  T sum = start;
  for (Index b = threadIdx.x; b < blocks; b += 256) sum = combine(sum, partial[b]);
  const T total = BlockReduce(storage).Reduce(sum, combine);
  if (threadIdx.x == 0) then(total);
}

/// Gpu's Runtime (solver/backend/gpu.hpp) on the first CUDA device. All work goes to one stream, in order, but for the
/// copying of snapshots; memory comes from the device's pool, which keeps what it was given back, if it has one.
struct CudaRuntime {
  static cudaStream_t stream() { return memory().stream; }
  static void* queue() { return stream(); }

  static void* allocate(std::size_t bytes) {
    void* p = nullptr;
    if (memory().has_pool) {
      check_cuda(cudaMallocAsync(&p, bytes, stream()), "allocating memory");
    } else {
      check_cuda(cudaMalloc(&p, bytes), "allocating memory");
    }
    return p;
  }
  /// The snapshot thread frees its buffers on the copy stream, because the compute stream may be capturing a graph.
  static void release(void* p) noexcept {
    if (p == nullptr) return;  // no use in checking below
    if (!memory().has_pool) {
      cudaFree(p);
      return;
    }
    const bool launching = std::this_thread::get_id() == memory().thread;
    cudaFreeAsync(p, launching ? stream() : memory().beside);
  }

  /// Not from the pool, whose memory other processes cannot map.
  static void* allocate_message(std::size_t bytes) {
    void* p = nullptr;
    check_cuda(cudaMalloc(&p, bytes), "allocating memory");
    return p;
  }
  static void release_message(void* p) noexcept {
    if (p != nullptr) cudaFree(p);
  }

  /// Page-locked memory.
  static void* allocate_on_host(std::size_t bytes) {
    void* p = nullptr;
    check_cuda(cudaMallocHost(&p, bytes), "allocating page-locked memory");
    return p;
  }
  static void release_on_host(void* p) noexcept {
    if (p != nullptr) cudaFreeHost(p);
  }

  /// A moment between launches.
  class Mark {
   public:
    Mark() {
      check_cuda(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming), "taking a snapshot");
      check_cuda(cudaEventRecord(event_, stream()), "taking a snapshot");
    }
    ~Mark() { cudaEventDestroy(event_); }
    Mark(const Mark&) = delete;
    Mark& operator=(const Mark&) = delete;

   private:
    friend CudaRuntime;
    cudaEvent_t event_ = nullptr;
  };
  /// Copies as of the mark on a second stream, while the first goes on.
  static void copy_to_host_after(const Mark& mark, void* to, const void* from, std::size_t bytes) {
    if (bytes == 0) return;
    const cudaStream_t beside = memory().beside;
    check_cuda(cudaStreamWaitEvent(beside, mark.event_, 0), "copying a snapshot");
    check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, beside), "copying a snapshot");
    check_cuda(cudaStreamSynchronize(beside), "copying a snapshot");
  }
  static void copy_to_device(void* to, const void* from, std::size_t bytes) {
    copy(to, from, bytes, cudaMemcpyHostToDevice);
    wait();
  }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) {
    if (bytes == 0) return wait();  // memcpy would tell the compiler that no address is null
    void* staged = bytes <= largest_result ? memory().result_on_host : to;
    copy(staged, from, bytes, cudaMemcpyDeviceToHost);
    wait();
    if (staged != to) std::memcpy(to, staged, bytes);
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

  /// By way of page-locked memory, so that the host need not wait; before the next one it has waited for something.
  static void send(void* to, const void* from, std::size_t bytes) {
    std::memcpy(memory().sent_from_host, from, bytes);
    copy(to, memory().sent_from_host, bytes, cudaMemcpyHostToDevice);
  }

  template <class Body>
  static void launch(Index n, const Body& body, const int* flag) {
    if (n == 0) return;
    run_body<<<(n + 127) / 128, 128, 0, stream()>>>(n, body, flag);
    check_cuda(cudaGetLastError(), "starting a kernel");
  }

  template <class Body>
  static void launch_teams(Index n, const Body& body, const int* flag) {
    if (n == 0) return;
    run_team<<<(n + 3) / 4, 128, 0, stream()>>>(n, body, flag);
    check_cuda(cudaGetLastError(), "starting a kernel");
  }

  template <class T, class Of, class Combine, class Then>
  static void reduce(Index n, const T& start, const Of& of, const Combine& combine, const Then& then, const int* flag) {
    static_assert(sizeof(T) <= largest_partial && std::is_trivially_copyable_v<T>);
    const Index needed = (n + 127) / 128;
    const Index blocks = needed < most_blocks ? needed : most_blocks;
    T* partial = static_cast<T*>(memory().partial);
    if (blocks > 0) reduce_blocks<<<blocks, 128, 0, stream()>>>(n, start, of, combine, partial, flag);
    if (blocks <= one_stage) {
      finish_reduction<<<1, 256, 0, stream()>>>(blocks, start, combine, partial, then, flag);
    } else {
      const Index groups = (blocks + one_stage - 1) / one_stage;
      T* combined = partial + most_blocks;
      combine_blocks<<<groups, 256, 0, stream()>>>(blocks, one_stage, start, combine, partial, combined, flag);
      finish_reduction<<<1, 256, 0, stream()>>>(groups, start, combine, combined, then, flag);
    }
    check_cuda(cudaGetLastError(), "starting a kernel");
  }

  /// Runs work(where), which leaves a T there, and brings it to the host.
  template <class T, class Work>
  static T with_result(const Work& work) {
    static_assert(sizeof(T) <= largest_result && std::is_trivially_copyable_v<T>);
    work(static_cast<T*>(memory().result));
    T result;
    copy_to_host(&result, memory().result, sizeof(T));
    return result;
  }

  /// Launches kept as a CUDA graph: one launch in place of many, which is what a step of a small scene consists of.
  class Recording {
   public:
    Recording() = default;
    Recording(Recording&& r) noexcept : graph_(std::exchange(r.graph_, nullptr)) {}
    Recording& operator=(Recording&& r) noexcept {
      std::swap(graph_, r.graph_);
      return *this;
    }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;
    ~Recording() {
      if (graph_ != nullptr) cudaGraphExecDestroy(graph_);  // nothing to be done about a failure in a destructor
    }

    /// Records the launches of what(), which may ask for nothing but launches. A graph of the same kernels takes over
    /// their new arguments, which is cheaper than to make a new graph.
    template <class What>
    void record(const What& what) {
      cudaGraph_t launches = nullptr;
      check_cuda(cudaStreamBeginCapture(stream(), cudaStreamCaptureModeThreadLocal), "recording a step");
      try {
        what();
      } catch (...) {
        cudaStreamEndCapture(stream(), &launches);
        if (launches != nullptr) cudaGraphDestroy(launches);
        throw;
      }
      check_cuda(cudaStreamEndCapture(stream(), &launches), "recording a step");
      cudaGraphExecUpdateResultInfo told{};
      if (graph_ == nullptr || cudaGraphExecUpdate(graph_, launches, &told) != cudaSuccess) {
        cudaGetLastError();  // a graph of other kernels is no error
        if (graph_ != nullptr) check_cuda(cudaGraphExecDestroy(std::exchange(graph_, nullptr)), "recording a step");
        check_cuda(cudaGraphInstantiate(&graph_, launches, 0), "recording a step");
      }
      check_cuda(cudaGraphDestroy(launches), "recording a step");
    }
    void replay() { check_cuda(cudaGraphLaunch(graph_, stream()), "repeating a step"); }

   private:
    cudaGraphExec_t graph_ = nullptr;
  };

  /// offsets: n + 1 entries, the first 0.
  static void scan(const Index* counts, Index n, Index* offsets) {
    check_cuda(cudaMemsetAsync(offsets, 0, sizeof(Index), stream()), "clearing memory");
    with_scratch([&](void* scratch, std::size_t& bytes) {
      return cub::DeviceScan::InclusiveSum(scratch, bytes, counts, offsets + 1, static_cast<int>(n), stream());
    });
  }

  template <class Candidate, class Keep>
  static void select(Index n, const Candidate& candidate, const Keep& keep, Index* kept, Index* count) {
    const auto candidates = thrust::make_transform_iterator(thrust::make_counting_iterator(Index{0}), candidate);
    with_scratch([&](void* scratch, std::size_t& bytes) {
      return cub::DeviceSelect::If(scratch, bytes, candidates, kept, count, static_cast<int>(n), keep, stream());
    });
  }

  static void sort(std::uint64_t* key, Index* order, Index n, int used_bits) {
    DeviceBuffer<std::uint64_t, CudaRuntime> other_key;
    DeviceBuffer<Index, CudaRuntime> other_order;
    other_key.resize(n);
    other_order.resize(n);
    cub::DoubleBuffer<std::uint64_t> keys(key, other_key.data());
    cub::DoubleBuffer<Index> orders(order, other_order.data());
    with_scratch([&](void* scratch, std::size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys, orders, static_cast<int>(n), 0, used_bits, stream());
    });
    if (keys.Current() != key) copy_on_device(key, keys.Current(), n * sizeof(std::uint64_t));
    if (orders.Current() != order) copy_on_device(order, orders.Current(), n * sizeof(Index));
  }

 private:
  static constexpr std::size_t largest_result = 512;
  static constexpr std::size_t largest_partial = 256;
  /// Of a reduction: some 20 waves on the largest GPU, so that the last one, which is not full, costs little.
  static constexpr Index most_blocks = 32768;
  /// So many partial results one block combines; more are combined in two stages.
  static constexpr Index one_stage = 1024;
  struct Memory {
    cudaStream_t stream = nullptr;
    cudaStream_t beside = nullptr;
    std::thread::id thread = std::this_thread::get_id();  // that launches
    bool has_pool = false;                                // some drivers and virtual GPUs have none
    void* result = nullptr;                               // on the device
    void* partial = nullptr;                              // on the device
    void* result_on_host = nullptr;                       // page-locked
    void* sent_from_host = nullptr;                       // page-locked

    Memory() {
      check_cuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "starting");
      check_cuda(cudaStreamCreateWithFlags(&beside, cudaStreamNonBlocking), "starting");
      check_cuda(cudaMalloc(&result, largest_result), "allocating memory");
      check_cuda(cudaMalloc(&partial, (most_blocks + most_blocks / one_stage) * largest_partial), "allocating memory");
      check_cuda(cudaMallocHost(&result_on_host, largest_result), "allocating page-locked memory");
      check_cuda(cudaMallocHost(&sent_from_host, largest_result), "allocating page-locked memory");
      int device = 0;
      int pools = 0;
      cudaMemPool_t pool = nullptr;
      std::uint64_t keep_all = UINT64_MAX;
      check_cuda(cudaGetDevice(&device), "starting");
      check_cuda(cudaDeviceGetAttribute(&pools, cudaDevAttrMemoryPoolsSupported, device), "starting");
      has_pool = pools != 0;
      if (!has_pool) return;
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
