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
#include "solver/backend/gpu_sums.hpp"
#include "solver/backend/gpu_threads.hpp"
#include "solver/backend/list_limit.hpp"
#include "solver/backend/ranks.hpp"
#include "solver/backend/shared_on_host.hpp"

// The verbs of a backend on a device with its own memory and a thread for each particle. How such a device is reached
// is the Runtime's: CUDA's (solver/backend/cuda.cuh), or, in the tests, the host's with memory that nobody may touch
// but the device (tests/solver/guarded_runtime.hpp). A Runtime offers
//
//   allocate, release, copy_to_device, copy_to_host, copy_on_device     memory, in bytes
//   allocate_on_host, release_on_host     memory of the host that the device reaches, too
//   allocate_message, release_message     memory of the device that other processes' devices can be sent to and from
//   send                                  a few bytes to the device, without waiting
//   Mark, copy_to_host_after(mark, ...)   in another thread, beside what is asked for after the mark
//   launch, launch_teams, reduce          what Gpu hands on; they heed a flag on the device
//   scan, select, sort                    the same without a flag
//   Recording: record(what), replay()     launches kept and asked for again as one
//   wait, atomic_add
//   queue                                 the order of the device's work, for a link that has to keep it (DeviceLink)
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
  using Message = MessageBytes<Runtime>;
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
  static void* queue() { return Runtime::queue(); }

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
    if (key == 0 || shared != nullptr) return what();  // ranks wait for each other in the middle of it
    recording_.record(what);
    recorded_ = key;
    recording_.replay();
  }

  AccessListener* listener = nullptr;
  SharedScene* shared = nullptr;  // on several ranks, a GPU each; their numbers meet on the hosts

  [[nodiscard]] bool any(bool mine) const { return on_host().any(mine); }
  template <class Counters>
  void share_sums(Buffer<Counters>& counters) const {
    share(counters, [&](HostBuffer<Counters>& numbers) { on_host().share_sums(numbers); });
  }
  void share_marks(Buffer<std::uint8_t>& marks) const {
    share(marks, [&](HostBuffer<std::uint8_t>& numbers) { on_host().share_marks(numbers); });
  }
  void share_drift(const DriftBlocks& blocks, Buffer<DriftBox>& of_block) const {
    share(of_block, [&](HostBuffer<DriftBox>& boxes) { on_host().share_drift(blocks, boxes); });
  }
  template <class T>
  void share_changes(Buffer<T>& now, Buffer<T>& before) const {
    share(now, [&](HostBuffer<T>& numbers) {
      share(before, [&](HostBuffer<T>& old) { on_host().share_changes(numbers, old); });
    });
  }

  template <class Body>
  void for_each(Index n, const Body& body) const {
    require_particle_body<Body>();
    const Announcement announced(listener, access_of<Body>, flag_);
    Runtime::launch(n, body, flag_);
  }

  template <class T, class Of, class Combine>
  T reduce(Index n, const T& start, const Of& of, const Combine& combine) const {
    const T mine = reduce_here(n, start, of, combine);
    return shared == nullptr ? mine : total_of_ranks(shared->ranks, mine, start, combine);
  }
  template <class T, class Of, class Combine>
  T reduce(FluidCount n, const T& start, const Of& of, const Combine& combine) const {
    if (shared == nullptr) return reduce_here(n, start, of, combine);
    require_particle_body<Of>();
    const Announcement announced(listener, access_of<Of>, nullptr);
    return total_of_fluid(n, start, of, combine);
  }
  template <class T, class Of, class Combine>
  T reduce_here(Index n, const T& start, const Of& of, const Combine& combine) const {
    require_particle_body<Of>();
    const Announcement announced(listener, access_of<Of>, nullptr);
    if (n == 0) return start;
    return Runtime::template with_result<T>(
        [&](T* result) { Runtime::reduce(n, start, of, combine, Keep<T>{result}, nullptr); });
  }
  template <class T, class Of, class Combine, class Then>
  void reduce_then(Index n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    if (shared != nullptr) {
      if (!is_off()) run_with(reduce(n, start, of, combine), then);
      return;
    }
    const Announcement announced(listener, access_of<Of>, flag_);
    Runtime::reduce(n, start, of, combine, then, flag_);
  }
  template <class T, class Of, class Combine, class Then>
  void reduce_then(FluidCount n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    if (shared == nullptr) return reduce_then(n.count, start, of, combine, then);
    if (!is_off()) run_with(reduce(n, start, of, combine), then);
  }
  /// then(of(n) for the places n of a range's particles, four a cluster, combined); the same bits on any number of ranks.
  template <class T, class Of, class Combine, class Then>
  void reduce_members_then(const ClusterList& list, ClusterRange range, const T& start, const Of& of,
                           const Combine& combine, const Then& then) const {
    if (shared == nullptr) return reduce_then(range.count * cluster_size, start, of, combine, then);
    require_particle_body<Of>();
    Announcement announced(listener, access_of<Of>, flag_);
    if (!is_off()) run_with(total_of_members(announced, list, range, start, of, combine), then);
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
    countable_entries(
        reduce_here(static_cast<Index>(counts.size()), std::uint64_t{0},
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
    Announcement announced(listener, access_of<Body>, flag_, list);
    using Thread = SweepThread<Dim, From, Body, NoResult>;
    const Thread thread{list, range, records, metric, body, {}};
    announced.in_parts([&](const ClusterPart& part) {
      Runtime::launch(range.count * cluster_size, PartThread<Thread>{part, range, thread}, flag_);
    });
  }
  template <int Dim, class From, class Body, class T, class Combine, class Then>
  void sweep_then(const ClusterList& list, ClusterRange range, const From* records, const PairMetric<Dim>& metric,
                  const Body& body, const T& start, const Combine& combine, const Then& then) const {
    require_sweep_body<Body, Dim>();
    const SweepThread<Dim, From, Body, T> thread{list, range, records, metric, body, start};
    if (shared == nullptr) {
      const Announcement announced(listener, access_of<Body>, flag_);
      Runtime::reduce(range.count * cluster_size, start, thread, combine, then, flag_);
      return;
    }
    Announcement announced(listener, access_of<Body>, flag_, list);
    if (!is_off()) run_with(total_of_members(announced, list, range, start, thread, combine), then);
  }

 private:
  [[nodiscard]] SharedOnHost on_host() const { return {shared}; }

  /// what(numbers) with a buffer's numbers on the host, where there are several ranks.
  template <class T, class What>
  void share(Buffer<T>& buffer, const What& what) const {
    if (shared == nullptr) return;
    HostBuffer<T> numbers = download(buffer);
    what(numbers);
    upload(std::move(numbers), buffer);
  }

  /// True if what is asked for now is to be skipped; the host waits for the device to know.
  [[nodiscard]] bool is_off() const { return flag_ != nullptr && read(flag_) == 0; }

  template <class T, class Then>
  static void run_with(const T& total, const Then& then) {
    Runtime::launch(1, ThenThread<T, Then>{total, then}, nullptr);
  }

  /// Sums over the fluid of all ranks, along a tree over the blocks (BlockTree).
  template <class T, class Of, class Combine>
  T total_of_fluid(Index n, const T& start, const Of& of, const Combine& combine) const {
    Buffer<T> chunks;
    chunks.resize((n + sum_chunk - 1) / sum_chunk);
    Runtime::launch(static_cast<Index>(chunks.size()),
                    FoldThread<T, Of, Combine>{n, sum_chunk, start, of, combine, chunks.data()}, nullptr);
    return total_of_chunks(chunks, start, combine);
  }
  template <class T, class Of, class Combine>
  T total_of_members(Announcement& announced, const ClusterList& list, ClusterRange range, const T& start, const Of& of,
                     const Combine& combine) const {
    Buffer<T> terms;
    Buffer<T> chunks;
    terms.resize(range.count * cluster_size);
    chunks.resize((list.fluid_count + sum_chunk - 1) / sum_chunk);
    using Thread = KeepThread<Of, T>;
    announced.in_parts([&](const ClusterPart& part) {
      Runtime::launch(range.count * cluster_size, PartThread<Thread>{part, range, {of, terms.data()}}, nullptr);
    });
    Runtime::launch(static_cast<Index>(chunks.size()),
                    FoldClustersThread<T, Combine>{range, start, terms.data(), combine, chunks.data()}, nullptr);
    return total_of_chunks(chunks, start, combine);
  }
  template <class T, class Combine>
  T total_of_chunks(const Buffer<T>& chunks, const T& start, const Combine& combine) const {
    static_assert(!std::is_same_v<T, bool>, "a vector of them has no addresses");
    constexpr Index in_block = sum_block / sum_chunk;
    const auto n = static_cast<Index>(chunks.size());
    Buffer<T> blocks;
    blocks.resize((n + in_block - 1) / in_block);
    Runtime::launch(static_cast<Index>(blocks.size()),
                    FoldThread<T, EntryTerm<T>, Combine>{n, in_block, start, {chunks.data()}, combine, blocks.data()},
                    nullptr);
    BlockTree<T, Combine> tree(combine);
    std::int64_t block = shared->first_block;
    for (const T& sum : download(blocks)) tree.add(block++, sum);
    return total_of(shared->ranks, tree, start, combine);
  }

  bool stores_coefficients_ = false;
  const int* flag_ = nullptr;
  typename Runtime::Recording recording_;
  std::uint64_t recorded_ = 0;  // key of the recording
};

}  // namespace thalweg
