#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>

#include "physics/lane_math.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/backend/device.hpp"
#include "solver/backend/device_buffer.hpp"
#include "solver/backend/gpu_threads.hpp"
#include "solver/backend/list_limit.hpp"
#include "solver/backend/ranks.hpp"

// The verbs of a backend on a device with its own memory and a thread for each particle. How such a device is reached
// is the Runtime's: CUDA's (solver/backend/cuda.cuh), or, in the tests, the host's with memory that nobody may touch
// but the device (tests/solver/guarded_runtime.hpp). A Runtime offers
//
//   allocate, release, copy_to_device, copy_to_host, copy_on_device     memory, in bytes
//   send                                  a few bytes to the device, without waiting
//   Mark, copy_to_host_after(mark, ...)   in another thread, beside what is asked for after the mark
//   launch, launch_teams, reduce          what Gpu hands on; they heed a flag on the device
//   scan, select, sort                    the same without a flag
//   Recording: record(what), replay()     launches kept and asked for again as one
//   wait, atomic_add
namespace thalweg {

/// A GPU; the verbs are those of OpenMp (solver/backend/openmp.hpp), which says what each does.
template <class Runtime>
class Gpu {
 public:
  Gpu() = default;
  explicit Gpu(bool stores_coefficients) : stores_coefficients_(stores_coefficients) {}

  /// True: the viscous iteration stores the coefficient of every pair, 8 bytes an entry of the lists.
  [[nodiscard]] bool stores_coefficients() const { return stores_coefficients_; }
  using PairCoefficient = ShortFloat;
  static constexpr bool is_host = false;
  template <class T>
  using Buffer = DeviceBuffer<T, Runtime>;

  HOST_DEVICE static void atomic_add(std::int64_t* counter, std::int64_t amount) {
    Runtime::atomic_add(counter, amount);
  }

  template <class T>
  static void upload(HostBuffer<T>&& numbers, Buffer<T>& to) {
    to.resize(numbers.size());
    Runtime::copy_to_device(to.data(), numbers.data(), numbers.size() * sizeof(T));
  }
  template <class T>
  static void fill(Buffer<T>& buffer, std::size_t n, const T& value) {
    buffer.resize(n);
    Runtime::launch(static_cast<Index>(n), FillThread<T>{buffer.data(), value}, nullptr);
  }
  template <class T>
  static HostBuffer<T> download(const Buffer<T>& buffer, std::size_t from, std::size_t to) {
    HostBuffer<T> numbers(to - from);
    Runtime::copy_to_host(numbers.data(), buffer.data() + from, numbers.size() * sizeof(T));
    return numbers;
  }
  template <class T>
  static HostBuffer<T> download(const Buffer<T>& buffer) {
    return download(buffer, 0, buffer.size());
  }
  template <class T>
  static void write(const T& number, T* to) {
    static_assert(sizeof(T) <= 512 && std::is_trivially_copyable_v<T>);
    Runtime::send(to, &number, sizeof(T));
  }
  template <class T>
  static T read(const T* at) {
    T number;
    Runtime::copy_to_host(&number, at, sizeof(T));
    return number;
  }

  static void finish() { Runtime::wait(); }

  class AsyncDownload {
   public:
    template <class T>
    HostBuffer<T> download(const Buffer<T>& buffer) const {
      HostBuffer<T> numbers(buffer.size());
      Runtime::copy_to_host_after(*mark_, numbers.data(), buffer.data(), numbers.size() * sizeof(T));
      return numbers;
    }

   private:
    std::shared_ptr<typename Runtime::Mark> mark_ = std::make_shared<typename Runtime::Mark>();
  };
  static AsyncDownload async_download() { return {}; }

  const int* skip_unless(const int* flag) { return std::exchange(flag_, flag); }

  template <class What>
  void repeat(std::uint64_t key, const What& what) {
    if (key != 0 && key == recorded_) return recording_.replay();
    recorded_ = 0;
    if (key == 0) return what();
    recording_.record(what);
    recorded_ = key;
    recording_.replay();
  }

  AccessListener* listener = nullptr;
  // Several ranks compute on CPU cores so far.
  static constexpr SharedScene* shared = nullptr;
  static bool any(bool mine) { return mine; }
  template <class Counters>
  static void share_sums(const Buffer<Counters>&) {}
  static void share_marks(const Buffer<std::uint8_t>&) {}
  template <class T>
  static void share_changes(const Buffer<T>&, const Buffer<T>&) {}

  template <class Body>
  void for_each(Index n, const Body& body) const {
    require_particle_body<Body>();
    const Announcement announced(listener, access_of<Body>, flag_);
    Runtime::launch(n, body, flag_);
  }

  template <class T, class Of, class Combine>
  T reduce(Index n, const T& start, const Of& of, const Combine& combine) const {
    require_particle_body<Of>();
    const Announcement announced(listener, access_of<Of>, nullptr);
    if (n == 0) return start;
    return Runtime::template with_result<T>(
        [&](T* result) { Runtime::reduce(n, start, of, combine, Keep<T>{result}, nullptr); });
  }
  template <class T, class Of, class Combine>
  T reduce_here(Index n, const T& start, const Of& of, const Combine& combine) const {
    return reduce(n, start, of, combine);
  }
  template <class T, class Of, class Combine, class Then>
  void reduce_then(Index n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    const Announcement announced(listener, access_of<Of>, flag_);
    Runtime::reduce(n, start, of, combine, then, flag_);
  }

  /// body(i, team) for a team of threads each. Team::size threads run body together, each the same code; a team has
  ///
  ///   each(f), once(f)       f(lane) in every thread; f() in one
  ///   ballot(f)              the bits of f(lane), for all of them
  ///   any_bits(f)            f(lane) of all, or-ed
  ///   PerLane<T>, get(x, l)  a number of every thread's own, x[lane]; that of thread l, for all of them
  ///
  /// Whatever decides which of these is called next is the same in all threads of a team.
  template <class Body>
  void for_each_team(Index n, const Body& body) const {
    require_particle_body<Body>();
    const Announcement announced(listener, access_of<Body>, flag_);
    Runtime::launch_teams(n, body, flag_);
  }

  /// Throws InputError if the sum does not fit an Index.
  Index exclusive_scan(const Buffer<Index>& counts, Buffer<Index>& offsets) const {
    offsets.resize(counts.size() + 1);
    const Index* each = counts.data();
    countable_entries(reduce(static_cast<Index>(counts.size()), std::uint64_t{0},
                             declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index i) { return std::uint64_t{each[i]}; }),
                             [] HOST_DEVICE(std::uint64_t a, std::uint64_t b) { return a + b; }));
    Runtime::scan(counts.data(), static_cast<Index>(counts.size()), offsets.data());
    return read(offsets.data() + counts.size());
  }

  template <class Candidate, class Keep>
  void select(Index n, const Candidate& candidate, const Keep& keep, Buffer<Index>& kept, Index* count) const {
    require_particle_body<Keep>();
    const Announcement announced(listener, access_of<Keep>, nullptr);
    kept.resize(n);
    Runtime::select(n, candidate, keep, kept.data(), count);
  }

  static void sort_by_key(Buffer<std::uint64_t>& key, Buffer<Index>& order, int used_bits = 64) {
    Runtime::sort(key.data(), order.data(), static_cast<Index>(key.size()), used_bits);
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
  void sweep(const ClusterList& list, ClusterRange range, const From* records, const PairMetric<Dim>& metric,
             const Body& body) const {
    require_sweep_body<Body, Dim>();
    const Announcement announced(listener, access_of<Body>, flag_);
    Runtime::launch(range.count * cluster_size,
                    SweepThread<Dim, From, Body, NoResult>{list, range, records, metric, body, {}}, flag_);
  }
  template <int Dim, class From, class Body, class T, class Combine, class Then>
  void sweep_then(const ClusterList& list, ClusterRange range, const From* records, const PairMetric<Dim>& metric,
                  const Body& body, const T& start, const Combine& combine, const Then& then) const {
    require_sweep_body<Body, Dim>();
    const Announcement announced(listener, access_of<Body>, flag_);
    Runtime::reduce(range.count * cluster_size, start,
                    SweepThread<Dim, From, Body, T>{list, range, records, metric, body, start}, combine, then, flag_);
  }

 private:
  bool stores_coefficients_ = false;
  const int* flag_ = nullptr;
  typename Runtime::Recording recording_;
  std::uint64_t recorded_ = 0;  // key of the recording
};

}  // namespace thalweg
