#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/backend/buffer.hpp"
#include "solver/backend/pack.hpp"
#include "solver/state/cluster_list.hpp"

namespace thalweg {

/// Sorts `order` (any integers) by `key`, keeping the order of equal keys; key is sorted along. (openmp_sort.cpp)
void stable_sort_by_key(HostBuffer<std::uint64_t>& key, HostBuffer<Index>& order);

/// CPU cores through OpenMP: the verbs every backend offers. W is the number of floats in a register. Pair sums are
/// computed in Real, float or double, from records that are single either way.
/// All results are independent of the number of threads, bit for bit.
template <int W = native_width, class Real = float>
struct OpenMp {
  /// Whether sweeps of an iteration keep what they know of a pair or compute it again: memory is plentiful here and
  /// arithmetic is not, on a GPU the other way round.
  static constexpr bool stores_coefficients = true;
  using PairCoefficient = std::conditional_t<sizeof(Real) == sizeof(float), ShortFloat, float>;
  template <class T>
  using Buffer = HostBuffer<T>;

  /// The host reads the device's numbers without asking for them.
  static constexpr bool is_host = true;

  int threads = omp_get_max_threads();

  /// Fewer particles (a few ns each in a particle pass) or clusters (some hundred ns each in a sweep) than these are
  /// not worth waking other threads for: ten to twenty microseconds, more on a busy machine.
  static constexpr Index least_parallel = 16384;
  static constexpr Index least_parallel_clusters = 512;

  /// Adds to a counter that several particles may share; integers, so that the sum does not depend on the order.
  static void atomic_add(std::int64_t* counter, std::int64_t amount) {
    __atomic_fetch_add(counter, amount, __ATOMIC_RELAXED);
  }

  /// Takes numbers from the host to the device, and makes a buffer of n equal ones.
  template <class T>
  static void put(HostBuffer<T>&& numbers, Buffer<T>& to) {
    to = std::move(numbers);
  }
  template <class T>
  static void fill(Buffer<T>& buffer, std::size_t n, const T& value) {
    buffer.assign(n, value);
  }
  /// The buffer's entries [from, to) for the host to read; valid until the buffer changes.
  template <class T>
  static std::span<const T> on_host(const Buffer<T>& buffer, std::size_t from, std::size_t to) {
    return std::span<const T>(buffer).subspan(from, to - from);
  }
  template <class T>
  static std::span<const T> on_host(const Buffer<T>& buffer) {
    return buffer;
  }

  /// Puts one number in its place on the device, and asks for one.
  template <class T>
  static void send(const T& number, T* to) {
    *to = number;
  }
  template <class T>
  static T look(const T* at) {
    return *at;
  }

  /// Until everything asked for is done.
  static void finish() {}

  /// Brings to the host what had been asked for by now, from another thread and while more is being asked for.
  struct Beside {
    template <class T>
    static std::span<const T> on_host(const Buffer<T>& buffer) {
      return buffer;
    }
  };
  static Beside beside() { return {}; }

  /// From here on for_each, reduce_then, sweep and sweep_then do nothing while *flag, a number on the device, is 0;
  /// nullptr: they always do. So work can be asked for before it is known whether it has to be done. Returns the flag
  /// before.
  const int* only_if(const int* flag) { return std::exchange(flag_, flag); }

  /// what(), whose launches a device may keep and repeat as one if it is asked for with the same `key` again: what they
  /// depend on, but for numbers on the device. 0: different every time.
  template <class What>
  static void repeat(std::uint64_t, const What& what) {
    what();
  }

  /// body(i) for i in [0, n): the particle pass.
  template <class Body>
  void for_each(Index n, const Body& body) const {
    if (is_off()) return;
#pragma omp parallel for schedule(static) num_threads(threads) if (n >= least_parallel)
    for (Index i = 0; i < n; ++i) body(i);
  }

  /// combine(… combine(combine(start, of(0)), of(1)) …), over blocks of a fixed size so that rounding does not depend
  /// on the threads. T is copied freely; combine is associative up to rounding, and start changes nothing it is
  /// combined with.
  template <class T, class Of, class Combine>
  T reduce(Index n, T start, const Of& of, const Combine& combine) const {
    constexpr Index block = 2048;
    const Index blocks = (n + block - 1) / block;
    std::vector<Partial<T>> partial(blocks, Partial<T>{start});
#pragma omp parallel for schedule(static) num_threads(threads) if (n >= least_parallel)
    for (Index b = 0; b < blocks; ++b) {
      T sum = start;
      const Index end = (b + 1) * block < n ? (b + 1) * block : n;
      for (Index i = b * block; i < end; ++i) sum = combine(sum, of(i));
      partial[b].sum = sum;
    }
    T total = start;
    for (const Partial<T>& p : partial) total = combine(total, p.sum);
    return total;
  }

  /// then(reduce(n, start, of, combine)), on the device: the host does not wait for it.
  template <class T, class Of, class Combine, class Then>
  void reduce_then(Index n, const T& start, const Of& of, const Combine& combine, const Then& then) const {
    if (!is_off()) then(reduce(n, start, of, combine));
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

  void sort_by_key(Buffer<std::uint64_t>& key, Buffer<Index>& order) const { stable_sort_by_key(key, order); }

  /// buffer[i] = old buffer[order[i]].
  template <class T>
  void reorder(Buffer<T>& buffer, const Buffer<Index>& order, Buffer<T>& scratch) const {
    scratch.resize(buffer.size());
    const T* from = buffer.data();
    T* to = scratch.data();
    const Index* source = order.data();
    for_each(static_cast<Index>(order.size()), [=](Index i) { to[i] = from[source[i]]; });
    for (std::size_t i = order.size(); i < buffer.size(); ++i) to[i] = from[i];
    buffer.swap(scratch);
  }

  /// The pair sweep: for every particle i of the visited clusters, body.end(i, sum over j of body.pair(i, j)).
  ///
  ///   Body::quads                                 which quads of a record pair() reads (Quads)
  ///   Body::Sum<L>                                a struct of L's that starts at zero
  ///   pair(a, b, separation, entry, sum)          lane-typed and branch-free; arrays with one number a pair keep this
  ///                                               one (these, of a pack) at `entry` (lane_load, lane_store)
  ///   end(i, Sum<float>)                          once a particle; in Sum<Real> if it can take it
  ///
  /// From Vectors in place of records only `work` of a and b is read, and the separation is not to be used.
  /// Four particles (a cluster) meet pairs/4 neighbours at a time; a neighbour's record is read once for all four.
  template <int Dim, class From, class Body>
  void sweep(const ClusterList& list, ClusterRange range, const From* records, const Vec<Dim, float>& quantum,
             const Body& body) const {
    if (is_off()) return;
#pragma omp parallel for schedule(dynamic, 32) num_threads(threads) if (range.count >= least_parallel_clusters)
    for (Index n = 0; n < range.count; ++n) {
      sweep_cluster<Dim>(list, range[n], records, quantum, body, [&](Index i, const auto& sum) { body.end(i, sum); });
    }
  }

  /// The sweep whose end() returns a T; then(start combined with all of them), on the device.
  template <int Dim, class From, class Body, class T, class Combine, class Then>
  void sweep_then(const ClusterList& list, ClusterRange range, const From* records, const Vec<Dim, float>& quantum,
                  const Body& body, const T& start, const Combine& combine, const Then& then) const {
    if (is_off()) return;
    constexpr Index block = 32;
    const Index blocks = (range.count + block - 1) / block;
    std::vector<Partial<T>> partial(blocks, Partial<T>{start});
#pragma omp parallel for schedule(static) num_threads(threads) if (range.count >= least_parallel_clusters)
    for (Index b = 0; b < blocks; ++b) {
      T total = start;
      const Index end = (b + 1) * block < range.count ? (b + 1) * block : range.count;
      for (Index n = b * block; n < end; ++n) {
        sweep_cluster<Dim>(list, range[n], records, quantum, body,
                           [&](Index i, const auto& sum) { total = combine(total, body.end(i, sum)); });
      }
      partial[b].sum = total;
    }
    T total = start;
    for (const Partial<T>& p : partial) total = combine(total, p.sum);
    then(total);
  }

 private:
  template <class T>
  struct Partial {  // keeps threads from writing to neighbouring bits of a std::vector<bool>
    T sum;
  };
  static constexpr Index scan_block = 4096;

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

  /// How many pairs a sweep computes at a time: a register full, but no less than one neighbour of a cluster.
  static constexpr int pairs = std::max(W * int{sizeof(float)} / int{sizeof(Real)}, int{cluster_size});
  using F = Pack<pairs>;  // as records hold them
  using L = Pack<pairs, Real>;
  using I = IntPack<pairs>;
  template <int Dim>
  using LaneOf = Lane<Dim, L, I>;

  /// Entry k of every quad, spread over the lanes of its group.
  template <std::size_t k>
  static L spread(const F& quad) {
    return to_real<Real>(splat_in_groups<k>(quad));
  }

  /// The quads a body asks for, of the records whose quads `quad_of(q)` yields as one pack.
  template <int Dim, unsigned quads, class QuadOf>
  static LaneOf<Dim> read_lane(const QuadOf& quad_of) {
    LaneOf<Dim> lane{};
    const F place = quad_of(0);
    lane.place[0] = place_bits(splat_in_groups<0>(place));
    if constexpr (Dim == 3) lane.place[1] = place_bits(splat_in_groups<1>(place));
    lane.place[Dim - 1] = place_bits(splat_in_groups<2>(place));
    lane.volume = spread<3>(place);
    if constexpr ((quads & quad_motion) != 0) {
      const F motion = quad_of(1);
      lane.velocity = read_vector<Dim>(motion);
      lane.pressure = spread<3>(motion);
    }
    if constexpr ((quads & quad_matter) != 0) {
      const F matter = quad_of(2);
      lane.excess = spread<0>(matter);
      lane.viscosity = spread<1>(matter);
      lane.phase = spread<2>(matter);
      lane.state = spread<3>(matter);
    }
    if constexpr ((quads & quad_work) != 0) lane.work = read_vector<Dim>(quad_of(3));
    return lane;
  }

  template <int Dim>
  static Vec<Dim, L> read_vector(const F& quad) {
    Vec<Dim, L> v{};
    v[0] = spread<0>(quad);
    if constexpr (Dim == 3) v[1] = spread<1>(quad);
    v[Dim - 1] = spread<2>(quad);
    return v;
  }

  static I place_bits(const F& numbers) { return (typename I::Vector)numbers.v; }

  /// The four particles of a cluster in the lanes of every group: the transpose of what read_lane does for neighbours.
  template <int Dim>
  static LaneOf<Dim> read_cluster(const Record* records, const std::array<Index, cluster_size>& member) {
    LaneOf<Dim> lane{};
    const auto gather_single = [&](auto field) { return gather_quad(records, member, field); };
    const auto gather = [&](auto field) { return to_real<Real>(gather_single(field)); };
    for (int k = 0; k < Dim; ++k) {
      lane.place[k] =
          place_bits(gather_single([k](const Record& r) { return std::bit_cast<float>(r.place[axis<Dim>(k)]); }));
      lane.velocity[k] = gather([k](const Record& r) { return r.velocity[axis<Dim>(k)]; });
      lane.work[k] = gather([k](const Record& r) { return r.work[axis<Dim>(k)]; });
    }
    lane.volume = gather([](const Record& r) { return r.volume; });
    lane.pressure = gather([](const Record& r) { return r.pressure; });
    lane.excess = gather([](const Record& r) { return r.excess; });
    lane.viscosity = gather([](const Record& r) { return r.viscosity; });
    lane.phase = gather([](const Record& r) { return r.phase; });
    lane.state = gather([](const Record& r) { return r.state; });
    return lane;
  }

  template <int Dim>
  static LaneOf<Dim> read_cluster(const Vectors* vectors, const std::array<Index, cluster_size>& member) {
    LaneOf<Dim> lane{};
    for (int k = 0; k < Dim; ++k) {
      lane.work[k] =
          to_real<Real>(gather_quad(vectors, member, [k](const Vectors& v) { return v.work[axis<Dim>(k)]; }));
    }
    return lane;
  }

  /// field() of the four particles of a cluster, in the lanes of every group.
  template <class From, class Field>
  static F gather_quad(const From* from, const std::array<Index, cluster_size>& member, const Field& field) {
    Quad q{};
    for (Index l = 0; l < cluster_size; ++l) q[l] = field(from[member[l]]);
    return repeat_quad<pairs>(q);
  }

  /// Whether a body's end takes sums as they were summed.
  template <class Body>
  static constexpr bool ends_in_real = requires(const Body& body, const typename Body::template Sum<Real>& sum) {
    body.end(Index{}, sum);
  };

  template <int Dim, class From, class Body, class EndOf>
  static void sweep_cluster(const ClusterList& list, Index cluster, const From* records, const Vec<Dim, float>& quantum,
                            const Body& body, const EndOf& end_of) {
    constexpr int groups = pairs / int{cluster_size};

    const Index first = list.first(cluster);
    const Index last = list.last(cluster);
    std::array<Index, cluster_size> member{};
    for (Index l = 0; l < cluster_size; ++l) member[l] = first + l < last ? first + l : last - 1;
    const LaneOf<Dim> a = read_cluster<Dim>(records, member);

    typename Body::template Sum<L> sum{};
    const Index end = list.begin[cluster + 1];
    for (Index e = list.begin[cluster]; e < end; e += groups) {
      const Index* j = list.entries + e;
      if constexpr (std::is_same_v<From, Record>) {  // vectors of a neighbourhood stay in the first cache
        for (int g = 0; g < groups; ++g) __builtin_prefetch(records + j[list_prefetch + g]);
      }
      const Quad* neighbour[groups];
      for (int g = 0; g < groups; ++g) neighbour[g] = reinterpret_cast<const Quad*>(records + j[g]);
      const auto quad_of = [&](int q) { return join_quads<pairs>([&](int g) { return neighbour[g] + q; }); };
      LaneOf<Dim> b{};
      Separation<Dim, L> s{};
      if constexpr (std::is_same_v<From, Record>) {
        b = read_lane<Dim, Body::quads>(quad_of);
        for (int k = 0; k < Dim; ++k) s.r[k] = to_real<Real>(a.place[k] - b.place[k]) * L(quantum[k]);
        s.r2 = dot(s.r, s.r);
      } else {
        b.work = read_vector<Dim>(quad_of(0));
      }
      body.pair(a, b, s, std::size_t{e} * cluster_size, sum);
    }

    using Packs = std::array<L, sizeof(sum) / sizeof(L)>;
    using End = std::conditional_t<ends_in_real<Body>, Real, float>;
    const auto packs = std::bit_cast<Packs>(sum);
    std::array<std::array<End, packs.size()>, cluster_size> scalar{};
    for (std::size_t f = 0; f < packs.size(); ++f) {
      const auto total = sum_groups(packs[f]);
      for (Index l = 0; l < cluster_size; ++l) scalar[l][f] = static_cast<End>(total[l]);
    }
    for (Index l = 0; l < last - first; ++l) {
      end_of(first + l, std::bit_cast<typename Body::template Sum<End>>(scalar[l]));
    }
  }
};

}  // namespace thalweg
