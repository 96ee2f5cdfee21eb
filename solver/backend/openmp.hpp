#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/backend/buffer.hpp"
#include "solver/backend/device.hpp"
#include "solver/backend/openmp_lists.hpp"
#include "solver/backend/openmp_sweep.hpp"
#include "solver/backend/ranks.hpp"
#include "solver/backend/shared_on_host.hpp"

namespace thalweg {

/// Sorts `order` (any integers) by `key`, keeping the order of equal keys; key is sorted along. (openmp_sort.cpp)
void stable_sort_by_key(HostBuffer<std::uint64_t>& key, HostBuffer<Index>& order);

/// CPU cores through OpenMP: the verbs every backend offers. W is the number of floats in a register. Pair sums are
/// computed in Real, float or double, from records that are single either way.
/// All results are independent of the number of threads, bit for bit.
template <int W = native_width, class Real = float>
struct OpenMp : SharedOnHost {
  /// True: the sweeps of an iteration store the coefficient of every pair. False: they compute it again. Memory is
  /// plentiful here and arithmetic is not; on a GPU its free memory decides.
  static constexpr bool stores_coefficients() { return true; }
  using PairCoefficient = std::conditional_t<sizeof(Real) == sizeof(float), ShortFloat, float>;
  template <class T>
  using Buffer = HostBuffer<T>;

  /// True: the host reads the device's numbers where they lie.
  static constexpr bool is_host = true;

  int threads = omp_get_max_threads();
  AccessListener* listener = nullptr;

  /// Fewer particles (a few ns each in a particle pass) or clusters (some hundred ns each in a sweep) than these are
  /// not worth waking other threads for: ten to twenty microseconds, more on a busy machine.
  static constexpr Index least_parallel = 16384;
  static constexpr Index least_parallel_clusters = 512;
  static constexpr Index clusters_together = 4;  // make_lists

  /// Adds to a counter that several particles may share; integers, so that the sum does not depend on the order.
  static void atomic_add(std::int64_t* counter, std::int64_t amount) {
    __atomic_fetch_add(counter, amount, __ATOMIC_RELAXED);
  }

  /// Moves numbers from the host to the device.
  template <class T>
  static void upload(HostBuffer<T>&& numbers, Buffer<T>& to) {
    to = std::move(numbers);
  }
  /// Makes a buffer of n equal numbers.
  template <class T>
  static void fill(Buffer<T>& buffer, std::size_t n, const T& value) {
    buffer.assign(n, value);
  }
  /// The buffer's entries [from, to) for the host to read; valid until the buffer changes.
  template <class T>
  static std::span<const T> download(const Buffer<T>& buffer, std::size_t from, std::size_t to) {
    return std::span<const T>(buffer).subspan(from, to - from);
  }
  template <class T>
  static std::span<const T> download(const Buffer<T>& buffer) {
    return buffer;
  }

  /// A message between ranks, where the device and the ranks both reach it.
  using Message = HostBuffer<std::byte>;

  /// Writes one number on the device.
  template <class T>
  static void write(const T& number, T* to) {
    *to = number;
  }
  /// Reads one number from the device; the host waits for it.
  template <class T>
  static T read(const T* at) {
    return *at;
  }

  /// Waits until everything asked for is done.
  static void finish() {}

  /// Downloads as of now, from another thread, while the device goes on.
  struct AsyncDownload {
    template <class T>
    static std::span<const T> download(const Buffer<T>& buffer) {
      return buffer;
    }
  };
  static AsyncDownload async_download() { return {}; }

  /// From here on for_each, reduce_then, sweep and sweep_then do nothing while *flag, a number on the device, is 0;
  /// nullptr: they always run. So the host can hand over work that may prove unnecessary. Returns the flag before.
  const int* skip_unless(const int* flag) { return std::exchange(flag_, flag); }

  /// what(), whose launches a device may keep and repeat as one if it is asked for with the same `key` again: what they
  /// depend on, but for numbers on the device. 0: different every time.
  template <class What>
  static void repeat(std::uint64_t, const What& what) {
    what();
  }

  /// body(i) for i in [0, n): the particle pass.
  template <class Body>
  void for_each(Index n, const Body& body) const {
    require_particle_body<Body>();
    const Announcement announced(listener, access_of<Body>, flag_);
    if (is_off()) return;
#pragma omp parallel for schedule(static) num_threads(threads) if (n >= least_parallel)
    for (Index i = 0; i < n; ++i) body(i);
  }

  /// combine(… combine(combine(start, of(0)), of(1)) …), over blocks of a fixed size so that rounding does not depend
  /// on the threads. T is copied freely; combine is associative up to rounding, and start changes nothing it is
  /// combined with. On several ranks the result is that of all ranks' terms, one rank after the other.
  template <class T, class Of, class Combine>
  T reduce(Index n, T start, const Of& of, const Combine& combine) const {
    const T mine = reduce_here(n, start, of, combine);
    return shared == nullptr ? mine : total_of_ranks(shared->ranks, mine, start, combine);
  }
  /// The same over the fluid: whatever ranks it lies on, the same bits.
  template <class T, class Of, class Combine>
  T reduce(FluidCount n, T start, const Of& of, const Combine& combine) const {
    return total(block_tree(n, start, of, combine, first_block()), start, combine);
  }
  /// Over this rank's terms alone.
  template <class T, class Of, class Combine>
  T reduce_here(Index n, T start, const Of& of, const Combine& combine) const {
    return block_tree(n, start, of, combine, 0).total(start);
  }

  /// then(reduce(n, start, of, combine)), on the device: the host does not wait for it.
  template <class T, class Of, class Combine, class Then>
  void reduce_then(Index n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    if (!is_off()) then(reduce(n, start, of, combine));
  }
  template <class T, class Of, class Combine, class Then>
  void reduce_then(FluidCount n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    if (!is_off()) then(reduce(n, start, of, combine));
  }
  /// then(of(c) for every cluster c of a range, combined), on the device; the same bits on any number of ranks.
  template <class T, class Of, class Combine, class Then>
  void reduce_clusters_then(const ClusterList& list, ClusterRange range, const T& start, const Of& of,
                            const Combine& combine, const Then& then) const {
    require_particle_body<Of>();
    Announcement announced(listener, access_of<Of>, flag_);
    if (is_off()) return;
    then(
        total_of_clusters(announced, list, range, start, combine, [&](Index c, T& sum) { sum = combine(sum, of(c)); }));
  }

  /// offsets[i] = sum of counts before i, offsets[n] = total, which is returned.
  Index exclusive_scan(const Buffer<Index>& counts, Buffer<Index>& offsets) const {
    const auto n = static_cast<Index>(counts.size());
    offsets.resize(std::size_t{n} + 1);
    const Index blocks = (n + scan_block - 1) / scan_block;
    std::vector<Index> before(blocks + std::size_t{1}, 0);
    for_each_block(blocks, n, [&](Index b, Index from, Index to) {
      for (Index i = from; i < to; ++i) before[b + 1] += counts[i];
    });
    for (Index b = 0; b < blocks; ++b) before[b + 1] += before[b];
    for_each_block(blocks, n, [&](Index b, Index from, Index to) {
      Index sum = before[b];
      for (Index i = from; i < to; ++i) offsets[i] = sum, sum += counts[i];
    });
    offsets[n] = before[blocks];
    return before[blocks];
  }

  /// Those of candidate(0) … candidate(n - 1) that keep(), in order, at the beginning of `kept`, which has room for all
  /// of them; *count is how many.
  template <class Candidate, class Keep>
  void select(Index n, const Candidate& candidate, const Keep& keep, Buffer<Index>& kept, Index* count) const {
    require_particle_body<Keep>();
    const Announcement announced(listener, access_of<Keep>, nullptr);
    kept.resize(n);
    const Index blocks = (n + scan_block - 1) / scan_block;
    std::vector<Index> found(blocks);
    for_each_block(blocks, n, [&](Index b, Index from, Index to) {
      Index at = from;
      for (Index i = from; i < to; ++i) {
        const Index c = candidate(i);
        if (keep(c)) kept[at++] = c;
      }
      found[b] = at - from;
    });
    *count = 0;
    for (Index b = 0; b < blocks; ++b) {
      const auto from = kept.begin() + std::ptrdiff_t{b} * scan_block;
      if (*count != b * scan_block) std::copy(from, from + found[b], kept.begin() + *count);
      *count += found[b];
    }
  }

  /// found(hits) until the hits, one or more indices at a time (Hits), were all those in [begin, end) that pass `test`,
  /// in order. test takes the places of several particles, one integer lane a direction; each of `places` can be read
  /// filter_overrun entries beyond its last.
  template <int Dim, class Test, class Found>
  static void filter(const Vec<Dim, const std::int32_t*>& places, Index begin, Index end, const Test& test,
                     const Found& found) {
    static_assert(W <= filter_overrun);
    for (Index j = begin; j < end; j += W) {
      Vec<Dim, IntPack<W>> place{};
      for (int k = 0; k < Dim; ++k) __builtin_memcpy(&place[k].v, places[k] + j, sizeof(place[k].v));
      std::uint32_t bits = bits_of(test(place));
      if (end - j < W) bits &= (1U << (end - j)) - 1;
      found(Hits<W>{j, bits});
    }
  }

  /// Makes the lists of n clusters, list c from begin[c] on, and `spare` entries behind; returns how many are before those.
  /// search(group, lists) adds the lists of a group of clusters to a ListScratch (openmp_lists.hpp).
  template <int Dim, class Search>
  Index make_lists(Index n, const Search& search, Buffer<Index>& begin, Buffer<Index>& entries, Index spare) const {
    require_particle_body<Search>();
    const Announcement announced(listener, access_of<Search>, nullptr);
    return OpenMpLists<W, Dim>{threads}.make(n, search, begin, entries, spare);
  }

  /// Sorts `order` by `key`, of which no bit from used_bits on is set, keeping the order of equal keys.
  void sort_by_key(Buffer<std::uint64_t>& key, Buffer<Index>& order, int /*used_bits*/ = 64) const {
    stable_sort_by_key(key, order);
  }

  /// buffer[i] = old buffer[order[i]]; entries beyond the order stay.
  template <class T>
  void reorder(Buffer<T>& buffer, const Buffer<Index>& order, Buffer<T>& scratch) const {
    scratch.resize(buffer.size());
    const T* from = buffer.data();
    T* to = scratch.data();
    const Index* source = order.data();
    const auto sorted = static_cast<Index>(order.size());
    for_each(sorted, declare<Reads<>, Writes<>>([=](Index i) { to[i] = from[source[i]]; }));
    for_each(static_cast<Index>(buffer.size() - sorted),
             declare<Reads<>, Writes<>>([=](Index i) { to[sorted + i] = from[sorted + i]; }));
    buffer.swap(scratch);
  }

  /// The pair sweep: for every particle i of the visited clusters, body.end(i, sum over j of body.pair(i, j)).
  ///
  ///   Body::neighbours                    the fields that pair() reads of a and b; their quads are loaded
  ///   Body::reads, Body::writes           the other fields of particle i that end() reads, and those it writes
  ///   Body::kernel                        the parts of the kernel that pair() needs (PairKernel)
  ///   Body::Sum<L>                        a struct of L's that starts at zero
  ///   pair(a, b, geometry, entry, sum)    lane-typed and branch-free; arrays with one number a pair keep this one
  ///                                       (these, of a pack) at `entry` (lane_load, lane_store)
  ///   end(i, Sum<float>)                  once a particle; in Sum<Real> if it can take it
  ///
  /// From Vectors in place of records only `work` of a and b is read, and the geometry is not set.
  /// Four particles (a cluster) meet pairs/4 neighbours at a time; a neighbour's record is read once for all four.
  template <int Dim, class From, class Body>
  void sweep(const ClusterList& list, ClusterRange range, const From* records, const PairMetric<Dim>& metric,
             const Body& body) const {
    require_sweep_body<Body, Dim>();
    Announcement announced(listener, access_of<Body>, flag_, list);
    if (is_off()) return;
    announced.in_parts([&](const ClusterPart& part) {
#pragma omp parallel for schedule(dynamic, 32) num_threads(threads) if (range.count >= least_parallel_clusters)
      for (Index n = 0; n < range.count; ++n) {
        if (n % progress_every == 0 && omp_get_thread_num() == 0) announced.progress();
        if (!part.has(range[n])) continue;
        Sweep::template visit<Dim>(list, range[n], records, metric, body,
                                   [&](Index i, const auto& sum) { body.end(i, sum); });
      }
    });
  }

  /// The sweep whose end() returns a T; then(start combined with all of them), on the device.
  template <int Dim, class From, class Body, class T, class Combine, class Then>
  void sweep_then(const ClusterList& list, ClusterRange range, const From* records, const PairMetric<Dim>& metric,
                  const Body& body, const T& start, const Combine& combine, const Then& then) const {
    require_sweep_body<Body, Dim>();
    Announcement announced(listener, access_of<Body>, flag_, list);
    if (is_off()) return;
    then(total_of_clusters(announced, list, range, start, combine, [&](Index c, T& sum) {
      Sweep::template visit<Dim>(list, c, records, metric, body,
                                 [&](Index i, const auto& of_pairs) { sum = combine(sum, body.end(i, of_pairs)); });
    }));
  }

 private:
  using Sweep = OpenMpSweep<W, Real>;

  template <class T>
  struct Partial {  // keeps threads from writing to neighbouring bits of a std::vector<bool>
    T sum;
  };
  static constexpr Index scan_block = 4096;
  /// Particles in a block of a sum. Ranks have whole blocks of the fluid.
  static constexpr Index block = sum_block;
  static constexpr Index clusters_in_block = block / cluster_size;
  /// While messages are on their way they are looked after every so many clusters, which is some hundred microseconds.
  static constexpr Index progress_every = 256;

  template <class T, class Of, class Combine>
  BlockTree<T, Combine> block_tree(Index n, const T& start, const Of& of, const Combine& combine,
                                   std::int64_t first) const {
    require_particle_body<Of>();
    const Announcement announced(listener, access_of<Of>, nullptr);
    const Index blocks = (n + block - 1) / block;
    std::vector<Partial<T>> partial(blocks, Partial<T>{start});
    for_each_term(blocks, n >= least_parallel, [&](Index b) {
      const Index end = (b + 1) * block < n ? (b + 1) * block : n;
      T sum = start;
      for (Index i = b * block; i < end; ++i) sum = combine(sum, of(i));
      partial[b].sum = sum;
    });
    return tree_of_blocks(first, partial, combine);
  }

  /// add(c, sum) for the clusters of a range, in blocks of the fluid's particles, of whatever clusters the range has in
  /// each; combined over all ranks. A block waits for copies if one of its clusters needs some.
  template <class T, class Combine, class Add>
  T total_of_clusters(Announcement& announced, const ClusterList& list, ClusterRange range, const T& start,
                      const Combine& combine, const Add& add) const {
    const Index blocks = (list.fluid_clusters + clusters_in_block - 1) / clusters_in_block;
    const auto first_of = [&](Index b) {
      const Index c = b * clusters_in_block;
      if (range.clusters == nullptr) return c < range.count ? c : range.count;
      return static_cast<Index>(std::lower_bound(range.clusters, range.clusters + range.count, c) - range.clusters);
    };
    std::vector<Partial<T>> partial(blocks, Partial<T>{start});
    announced.in_parts([&](const ClusterPart& part) {
      for_each_term(blocks, range.count >= least_parallel_clusters, [&](Index b) {
        if (b * clusters_in_block % progress_every == 0 && omp_get_thread_num() == 0) announced.progress();
        const Index from = first_of(b);
        const Index end = first_of(b + 1);
        if (!part.has(range, from, end)) return;
        T sum = start;
        for (Index n = from; n < end; ++n) add(range[n], sum);
        partial[b].sum = sum;
      });
    });
    return total(tree_of_blocks(first_block(), partial, combine), start, combine);
  }

  /// term(b) for every block of a sum.
  template <class Term>
  void for_each_term(Index blocks, bool parallel, const Term& term) const {
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads) if (parallel)
    for (Index b = 0; b < blocks; ++b) term(b);
  }
  template <class T, class Combine>
  static BlockTree<T, Combine> tree_of_blocks(std::int64_t first, const std::vector<Partial<T>>& partial,
                                              const Combine& combine) {
    BlockTree<T, Combine> tree(combine);
    for (const Partial<T>& of_block : partial) tree.add(first++, of_block.sum);
    return tree;
  }

  [[nodiscard]] std::int64_t first_block() const { return shared == nullptr ? 0 : shared->first_block; }

  /// Of blocks of the fluid, on all ranks.
  template <class T, class Combine>
  T total(BlockTree<T, Combine> tree, const T& start, const Combine& combine) const {
    return shared == nullptr ? tree.total(start) : total_of(shared->ranks, tree, start, combine);
  }

  const int* flag_ = nullptr;
  [[nodiscard]] bool is_off() const { return flag_ != nullptr && *flag_ == 0; }

  /// what(block, from, to) for the blocks of scan_block entries of [0, n).
  template <class What>
  void for_each_block(Index blocks, Index n, const What& what) const {
#pragma omp parallel for schedule(static) num_threads(threads) if (n >= least_parallel)
    for (Index b = 0; b < blocks; ++b) {
      what(b, b * scan_block, (b + 1) * scan_block < n ? (b + 1) * scan_block : n);
    }
  }
};

}  // namespace thalweg
