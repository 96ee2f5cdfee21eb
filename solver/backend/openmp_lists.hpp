#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/backend/buffer.hpp"
#include "solver/backend/list_limit.hpp"
#include "solver/backend/pack.hpp"
#include "solver/state/cluster_list.hpp"

namespace thalweg {

/// Numbers of the same lanes of packs, one after the other, with room for one pack more than they are.
template <class Number>
class LaneArray {
 public:
  Number* data() { return numbers_.data(); }
  void make_room(std::size_t n) {
    if (numbers_.size() < n) numbers_.resize(n + n / 2);
  }

 private:
  HostBuffer<Number> numbers_;
};

/// The lists of a few clusters in a row, as one thread of a CPU finds them: it first gathers the particles near all of these
/// clusters, at places relative to their middle, and then tests the gathered ones for each cluster. W is the number of
/// floats in a register.
template <int W, int Dim>
class ListScratch {
 public:
  /// The middle of some clusters and half their extent, and how far around them particles are gathered.
  struct Frame {
    Vec<Dim, std::int32_t> middle;  // [quanta]
    Vec<Dim, float> half;           // [m]
    Vec<Dim, float> quantum;        // [m]
    float reach2;                   // [m^2]
  };

  /// Forgets all lists.
  void start() { entries_used_ = lists_ = 0; }

  void gather_around(const Frame& frame) {
    frame_ = frame;
    gathered_ = 0;
  }

  /// Gathers particles [begin, end) that lie near the frame. The arrays can be read filter_overrun entries beyond.
  void gather(const Vec<Dim, const std::int32_t*>& places, Index begin, Index end) {
    index_.make_room(gathered_ + (end - begin) + W);
    square_.make_room(gathered_ + (end - begin) + W);
    for (int k = 0; k < Dim; ++k) along_[k].make_room(gathered_ + (end - begin) + W);
    for (Index j = begin; j < end; j += W) {
      Vec<Dim, Pack<W>> x{};
      Pack<W> r2(0.0F);
      Pack<W> gap2(0.0F);
      for (int k = 0; k < Dim; ++k) {
        IntPack<W> place;
        __builtin_memcpy(&place.v, places[k] + j, sizeof(place.v));
        x[k] = to_float(lane_difference(place, frame_.middle[k])) * Pack<W>(frame_.quantum[k]);
        r2 = r2 + x[k] * x[k];
        const Pack<W> gap = lane_max(lane_max(x[k], -x[k]) - Pack<W>(frame_.half[k]), Pack<W>(0.0F));
        gap2 = gap2 + gap * gap;
      }
      std::uint32_t bits = bits_of(gap2 < Pack<W>(frame_.reach2));
      if (end - j < W) bits &= (1U << (end - j)) - 1;
      for (int k = 0; k < Dim; ++k) store_lanes(along_[k].data() + gathered_, x[k], bits);
      store_lanes(square_.data() + gathered_, r2, bits);
      gathered_ += Hits<W>{j, bits}.write(index_.data() + gathered_);
    }
  }

  /// Closes what was gathered. phase: a byte a particle, or nullptr.
  void end_gathering(const std::uint8_t* phase) {
    square_.make_room(gathered_ + W);
    for (int l = 0; l < W; ++l) square_.data()[gathered_ + l] = INFINITY;  // in no cluster's reach
    if (phase == nullptr) return;
    phase_.make_room(gathered_ + W);
    for (Index n = 0; n < gathered_; ++n) phase_.data()[n] = phase[index_.data()[n]];
  }

  /// Adds to the list under way those gathered that lie within reach of a member of a cluster; gathers their phases if
  /// there are any. members: places relative to the frame's middle [m]; reach2 [m^2].
  /// |x - m|^2 < reach^2 is tested as |x|^2 < max(2 m.x + reach^2 - |m|^2), which takes three operations a member.
  void choose(const Vec<Dim, float> (&members)[cluster_size], float reach2, bool has_phases, std::uint8_t& phases) {
    make_room(gathered_);
    Pack<W> twice[cluster_size][Dim];
    Pack<W> bound[cluster_size];
    for (Index m = 0; m < cluster_size; ++m) {
      for (int k = 0; k < Dim; ++k) twice[m][k] = Pack<W>(2 * members[m][k]);
      bound[m] = Pack<W>(reach2 - dot(members[m], members[m]));
    }
    const auto load = [](const auto* from, auto& pack) { __builtin_memcpy(&pack.v, from, sizeof(pack.v)); };
    IntPack<W> found_phases(0);
    for (Index n = 0; n < gathered_; n += W) {
      Vec<Dim, Pack<W>> x{};
      for (int k = 0; k < Dim; ++k) load(along_[k].data() + n, x[k]);
      Pack<W> square;
      load(square_.data() + n, square);
      Pack<W> most = member_bound(x, twice[0], bound[0]);
      for (Index m = 1; m < cluster_size; ++m) most = lane_max(most, member_bound(x, twice[m], bound[m]));
      const auto near = square < most;
      const std::uint32_t bits = bits_of(near);
      IntPack<W> index;
      load(index_.data() + n, index);
      store_lanes(entries_.data() + entries_used_, index, bits);
      entries_used_ += static_cast<Index>(std::popcount(bits));
      if (has_phases) {
        IntPack<W> phase;
        load(phase_.data() + n, phase);
        found_phases.v |= phase.v & near.v;
      }
    }
    for (int l = 0; has_phases && l < W; ++l) phases |= static_cast<std::uint8_t>(found_phases.v[l]);
  }

  /// Adds hits of a filter to the list under way.
  void add(const Hits<W>& hits) {
    make_room(W);
    entries_used_ += hits.write(entries_.data() + entries_used_);
  }

  /// Ends the list under way, padded with `none`.
  void end_list(Index none) {
    make_room(list_padding);
    while (entries_used_ % list_padding != 0) entries_.data()[entries_used_++] = none;
    ends_.make_room(lists_ + 1);
    ends_.data()[lists_++] = entries_used_;
  }

  [[nodiscard]] Index entries() const { return entries_used_; }
  [[nodiscard]] Index lists() const { return lists_; }

  /// Writes where the lists begin in an array that has `before` entries of others.
  void write_begins(Index before, Index* begin) {
    for (Index l = 0; l < lists_; ++l) begin[l] = before + (l == 0 ? 0 : ends_.data()[l - 1]);
  }
  void write_entries(Index* to) { std::copy_n(entries_.data(), entries_used_, to); }

 private:
  static Pack<W> member_bound(const Vec<Dim, Pack<W>>& x, const Pack<W> (&twice)[Dim], Pack<W> bound) {
    for (int k = 0; k < Dim; ++k) bound = bound + twice[k] * x[k];
    return bound;
  }

  void make_room(Index more) { entries_.make_room(std::size_t{entries_used_} + more + W); }

  /// Writes the lanes whose bits are set, in order; may write a whole pack.
  template <class Number, class AnyPack>
  static void store_lanes(Number* to, AnyPack pack, std::uint32_t bits) {
#if defined(__AVX512F__)
    if constexpr (W == 16) {
      const __m512i kept = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), (__m512i)pack.v);
      _mm512_storeu_si512(to, kept);
      return;
    }
#endif
    Number numbers[W];
    __builtin_memcpy(numbers, &pack.v, sizeof(numbers));
    for (; bits != 0; bits &= bits - 1) *to++ = numbers[std::countr_zero(bits)];
  }

  Frame frame_{};
  LaneArray<float> along_[Dim];  // places of those gathered, relative to the frame's middle [m]
  LaneArray<float> square_;      // of their distances from it [m^2]
  LaneArray<Index> index_;
  LaneArray<std::int32_t> phase_;
  Index gathered_ = 0;
  LaneArray<Index> entries_;
  LaneArray<Index> ends_;
  Index entries_used_ = 0;
  Index lists_ = 0;
};

/// Makes all lists: blocks of groups of clusters, each in a thread's own memory, are searched and then copied.
template <int W, int Dim>
struct OpenMpLists {
  int threads;
  std::uint64_t most_entries = most_list_entries;

  /// As OpenMp::make_lists. The entries get a twentieth more room than they take, so that most searches need not be
  /// done once more for lack of room.
  template <class Search>
  Index make(Index n, const Search& search, HostBuffer<Index>& begin, HostBuffer<Index>& entries, Index spare) const {
    begin.resize(std::size_t{n} + 1);
    entries.resize(entries.capacity());
    std::uint64_t total = 0;
    while (true) {
      const std::size_t room = entries.size() < spare ? 0 : entries.size() - spare;
      total = search_blocks(search, begin.data(), entries.data(), room);
      countable_entries(total, most_entries);
      if (total <= room) break;
      HostBuffer<Index>().swap(entries);  // before more is asked for
      entries.resize(total + total / 20 + spare);
    }
    begin[n] = static_cast<Index>(total);
    entries.resize(total + spare);
    return begin[n];
  }

 private:
  /// Searches for all groups; entries are copied as long as they find room. Returns how many there are.
  template <class Search>
  std::uint64_t search_blocks(const Search& search, Index* begin, Index* entries, std::size_t room) const {
    constexpr Index block = 32;  // some 100 kB of entries, which stay in the second cache
    constexpr Index least_parallel = 128;
    const Index groups = search.groups();
    const Index blocks = (groups + block - 1) / block;
    std::uint64_t total = 0;
#pragma omp parallel num_threads(threads) if (groups >= least_parallel)
    {
      ListScratch<W, Dim> lists;
#pragma omp for ordered schedule(dynamic, 1)
      for (Index b = 0; b < blocks; ++b) {
        lists.start();
        for (Index g = b * block; g < std::min(groups, (b + 1) * block); ++g) search(g, lists);
        std::uint64_t before = 0;
#pragma omp ordered
        {
          before = total;
          total += lists.entries();
        }
        lists.write_begins(static_cast<Index>(before), begin + search.first_cluster(b * block));
        if (before + lists.entries() <= room) lists.write_entries(entries + before);
      }
    }
    return total;
  }
};

}  // namespace thalweg
