#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>

#include "physics/lane_math.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/state/cluster_list.hpp"

// The verbs of a backend on a device with its own memory and a thread for each particle. How such a device is reached
// is the Runtime's: CUDA's (solver/backend/cuda.cuh), or, in the tests, the host's with memory that nobody may touch
// but the device (tests/solver/guarded_runtime.hpp). A Runtime offers
//
//   allocate, release, copy_to_device, copy_to_host, copy_on_device     memory, in bytes
//   send                                  a few bytes to the device, without waiting
//   Mark, copy_to_host_after(mark, ...)   in another thread, beside what is asked for after the mark
//   launch, reduce, scan, select, sort    what Gpu hands on; launch and reduce heed a flag on the device
//   Recording: record(what), replay()     launches kept and asked for again as one
//   wait, atomic_add
namespace thalweg {

/// An array in the memory of a device. Contents are kept when it grows; new entries are uninitialised.
template <class T, class Runtime>
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;
  DeviceBuffer(DeviceBuffer&& b) noexcept { swap(b); }
  DeviceBuffer& operator=(DeviceBuffer&& b) noexcept {
    swap(b);
    return *this;
  }
  ~DeviceBuffer() { Runtime::release(data_); }

  void resize(std::size_t n) {
    if (n > capacity_) {
      DeviceBuffer larger;
      larger.data_ = static_cast<T*>(Runtime::allocate(n * sizeof(T)));
      larger.capacity_ = n;
      if (size_ > 0) Runtime::copy_on_device(larger.data_, data_, size_ * sizeof(T));
      swap(larger);
    }
    size_ = n;
  }
  void swap(DeviceBuffer& b) noexcept {
    std::swap(data_, b.data_);
    std::swap(size_, b.size_);
    std::swap(capacity_, b.capacity_);
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// One record as a lane of one pair, of the quads a body asks for.
template <int Dim, unsigned quads>
HOST_DEVICE inline Lane<Dim, float, std::int32_t> read_record(const Record* record) {
  struct alignas(16) Quad {
    float v[4];
  };
  const auto load = [record](int q) {
    Quad quad;
    const auto* from = static_cast<const char*>(__builtin_assume_aligned(record, 16)) + q * sizeof(Quad);
    memcpy(&quad, from, sizeof(Quad));
    return quad;
  };
  const auto vector = [](const Quad& quad) {
    Vec<Dim, float> v{};
    for (int k = 0; k < Dim; ++k) v[k] = quad.v[axis<Dim>(k)];
    return v;
  };
  Lane<Dim, float, std::int32_t> lane{};
  const Quad place = load(0);
  for (int k = 0; k < Dim; ++k) memcpy(&lane.place[k], &place.v[axis<Dim>(k)], sizeof(std::int32_t));
  lane.volume = place.v[3];
  if constexpr ((quads & quad_motion) != 0) {
    const Quad motion = load(1);
    lane.velocity = vector(motion);
    lane.pressure = motion.v[3];
  }
  if constexpr ((quads & quad_matter) != 0) {
    const Quad matter = load(2);
    lane.excess = matter.v[0];
    lane.viscosity = matter.v[1];
    lane.phase = matter.v[2];
    lane.state = matter.v[3];
  }
  if constexpr ((quads & quad_work) != 0) lane.work = vector(load(3));
  return lane;
}

template <int Dim, unsigned quads>
HOST_DEVICE inline Lane<Dim, float, std::int32_t> read_record(const Vectors* vectors) {
  Lane<Dim, float, std::int32_t> lane{};
  for (int k = 0; k < Dim; ++k) lane.work[k] = vectors->work[axis<Dim>(k)];
  return lane;
}

/// What a sweep's end() returns if it returns nothing.
struct NoResult {};

/// The pair sweep of one thread: particle n % 4 of the n/4-th cluster visited. The four threads of a cluster walk the
/// same list, so that a neighbour's record is fetched once for all of them. Result is what end() returns; a thread
/// without a particle returns `none`.
template <int Dim, class From, class Body, class Result>
struct SweepThread {
  ClusterList list;
  ClusterRange range;
  const From* records;
  Vec<Dim, float> quantum;
  Body body;
  Result none;

  HOST_DEVICE Result operator()(Index n) const {
    const Index cluster = range[n / cluster_size];
    const Index i = list.first(cluster) + n % cluster_size;
    if (i >= list.last(cluster)) return none;
    const auto a = read_record<Dim, Body::quads>(records + i);
    typename Body::template Sum<float> sum{};
    const Index end = list.begin[cluster + 1];
    for (Index e = list.begin[cluster]; e < end; ++e) {
      const auto b = read_record<Dim, Body::quads>(records + list.entries[e]);
      Separation<Dim, float> s{};
      for (int k = 0; k < Dim; ++k) s.r[k] = to_float(lane_difference(a.place[k], b.place[k])) * quantum[k];
      s.r2 = dot(s.r, s.r);
      body.pair(a, b, s, std::size_t{e} * cluster_size + n % cluster_size, sum);
    }
    if constexpr (std::is_same_v<Result, NoResult>) {
      body.end(i, sum);
      return none;
    } else {
      return body.end(i, sum);
    }
  }
};

/// Keeps the result of a reduction.
template <class T>
struct Keep {
  T* to;
  HOST_DEVICE void operator()(const T& result) const { *to = result; }
};

template <class T>
struct FillThread {
  T* to;
  T value;
  HOST_DEVICE void operator()(Index i) const { to[i] = value; }
};

/// The first `sorted` entries in a new order, the others as they are.
template <class T>
struct ReorderThread {
  const T* from;
  const Index* order;
  T* to;
  Index sorted;
  HOST_DEVICE void operator()(Index i) const { to[i] = from[i < sorted ? order[i] : i]; }
};

/// A GPU; the verbs are those of OpenMp (solver/backend/openmp.hpp), which says what each does.
template <class Runtime>
class Gpu {
 public:
  static constexpr bool stores_coefficients = false;
  using PairCoefficient = ShortFloat;
  static constexpr bool is_host = false;
  template <class T>
  using Buffer = DeviceBuffer<T, Runtime>;

  HOST_DEVICE static void atomic_add(std::int64_t* counter, std::int64_t amount) {
    Runtime::atomic_add(counter, amount);
  }

  template <class T>
  static void put(HostBuffer<T>&& numbers, Buffer<T>& to) {
    to.resize(numbers.size());
    Runtime::copy_to_device(to.data(), numbers.data(), numbers.size() * sizeof(T));
  }
  template <class T>
  static void fill(Buffer<T>& buffer, std::size_t n, const T& value) {
    buffer.resize(n);
    Runtime::launch(static_cast<Index>(n), FillThread<T>{buffer.data(), value}, nullptr);
  }
  template <class T>
  static HostBuffer<T> on_host(const Buffer<T>& buffer, std::size_t from, std::size_t to) {
    HostBuffer<T> numbers(to - from);
    Runtime::copy_to_host(numbers.data(), buffer.data() + from, numbers.size() * sizeof(T));
    return numbers;
  }
  template <class T>
  static HostBuffer<T> on_host(const Buffer<T>& buffer) {
    return on_host(buffer, 0, buffer.size());
  }
  template <class T>
  static void send(const T& number, T* to) {
    static_assert(sizeof(T) <= 512 && std::is_trivially_copyable_v<T>);
    Runtime::send(to, &number, sizeof(T));
  }
  template <class T>
  static T look(const T* at) {
    T number;
    Runtime::copy_to_host(&number, at, sizeof(T));
    return number;
  }

  static void finish() { Runtime::wait(); }

  class Beside {
   public:
    template <class T>
    HostBuffer<T> on_host(const Buffer<T>& buffer) const {
      HostBuffer<T> numbers(buffer.size());
      Runtime::copy_to_host_after(*mark_, numbers.data(), buffer.data(), numbers.size() * sizeof(T));
      return numbers;
    }

   private:
    std::shared_ptr<typename Runtime::Mark> mark_ = std::make_shared<typename Runtime::Mark>();
  };
  static Beside beside() { return {}; }

  const int* only_if(const int* flag) { return std::exchange(flag_, flag); }

  template <class What>
  void repeat(std::uint64_t key, const What& what) {
    if (key != 0 && key == recorded_) return recording_.replay();
    recorded_ = 0;
    if (key == 0) return what();
    recording_.record(what);
    recorded_ = key;
    recording_.replay();
  }

  template <class Body>
  void for_each(Index n, const Body& body) const {
    Runtime::launch(n, body, flag_);
  }

  template <class T, class Of, class Combine>
  static T reduce(Index n, const T& start, const Of& of, const Combine& combine) {
    if (n == 0) return start;
    return Runtime::template with_result<T>(
        [&](T* result) { Runtime::reduce(n, start, of, combine, Keep<T>{result}, nullptr); });
  }
  template <class T, class Of, class Combine, class Then>
  void reduce_then(Index n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    Runtime::reduce(n, start, of, combine, then, flag_);
  }

  static Index exclusive_scan(const Buffer<Index>& counts, Buffer<Index>& offsets) {
    offsets.resize(counts.size() + 1);
    Runtime::scan(counts.data(), static_cast<Index>(counts.size()), offsets.data());
    return look(offsets.data() + counts.size());
  }

  template <class Candidate, class Keep>
  static void select(Index n, const Candidate& candidate, const Keep& keep, Buffer<Index>& kept, Index* count) {
    kept.resize(n);
    Runtime::select(n, candidate, keep, kept.data(), count);
  }

  /// What a filter finds, one at a time here.
  struct Hit {
    Index j;
    HOST_DEVICE static Index count() { return 1; }
    HOST_DEVICE Index write(Index* to) const {
      *to = j;
      return 1;
    }
    HOST_DEVICE std::uint8_t any(const std::uint8_t* flags) const { return flags[j]; }
  };
  template <int Dim, class Test, class Found>
  HOST_DEVICE static void filter(const Vec<Dim, const std::int32_t*>& places, Index begin, Index end, const Test& test,
                                 const Found& found) {
    for (Index j = begin; j < end; ++j) {
      Vec<Dim, std::int32_t> place{};
      for (int k = 0; k < Dim; ++k) place[k] = places[k][j];
      if (test(place)) found(Hit{j});
    }
  }

  static void sort_by_key(Buffer<std::uint64_t>& key, Buffer<Index>& order) {
    Runtime::sort(key.data(), order.data(), static_cast<Index>(key.size()));
  }

  template <class T>
  static void reorder(Buffer<T>& buffer, const Buffer<Index>& order, Buffer<T>& scratch) {
    scratch.resize(buffer.size());
    const auto sorted = static_cast<Index>(order.size());
    const auto all = static_cast<Index>(buffer.size());
    Runtime::launch(all, ReorderThread<T>{buffer.data(), order.data(), scratch.data(), sorted}, nullptr);
    buffer.swap(scratch);
  }

  template <int Dim, class From, class Body>
  void sweep(const ClusterList& list, ClusterRange range, const From* records, const Vec<Dim, float>& quantum,
             const Body& body) const {
    Runtime::launch(range.count * cluster_size,
                    SweepThread<Dim, From, Body, NoResult>{list, range, records, quantum, body, {}}, flag_);
  }
  template <int Dim, class From, class Body, class T, class Combine, class Then>
  void sweep_then(const ClusterList& list, ClusterRange range, const From* records, const Vec<Dim, float>& quantum,
                  const Body& body, const T& start, const Combine& combine, const Then& then) const {
    Runtime::reduce(range.count * cluster_size, start,
                    SweepThread<Dim, From, Body, T>{list, range, records, quantum, body, start}, combine, then, flag_);
  }

 private:
  const int* flag_ = nullptr;
  typename Runtime::Recording recording_;
  std::uint64_t recorded_ = 0;  // key of the recording
};

}  // namespace thalweg
