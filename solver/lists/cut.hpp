#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/backend/buffer.hpp"
#include "solver/backend/ranks.hpp"
#include "solver/lists/sort.hpp"

// The global order of the particles, cut into a range for each rank, and the handing over of particles to the ranks in
// whose ranges they lie.
namespace thalweg {

/// The keys of a rank's particles, ascending, and what each of the fluid costs.
struct SortedKeys {
  std::vector<std::uint64_t> fluid;
  std::vector<std::uint64_t> walls;
  std::vector<std::int64_t> weight;
};

/// Begins of the ranks' ranges in the global order of the fluid and in that of the walls, and the end of the last: one
/// more than there are ranks.
struct Cut {
  std::vector<std::int64_t> fluid;
  std::vector<std::int64_t> walls;
};

/// Ranges of the walls begin at multiples of this many particles: the clusters that are searched together.
inline constexpr std::int64_t wall_group = 16;

/// Ranges as long as each other.
inline Cut cut_evenly(std::int64_t fluid, std::int64_t walls, int ranks) {
  Cut cut;
  for (int r = 0; r <= ranks; ++r) {
    cut.fluid.push_back(r == ranks ? fluid : fluid * r / ranks / sum_block * sum_block);
    cut.walls.push_back(r == ranks ? walls : walls * r / ranks / wall_group * wall_group);
  }
  return cut;
}

/// For each target the largest key below which lies no more than the target: below(key) is this rank's part of what
/// lies below, a whole number.
template <class Below>
std::vector<std::uint64_t> split_keys(Ranks& ranks, const std::vector<std::int64_t>& targets, int bits,
                                      const Below& below) {
  const std::size_t n = targets.size();
  std::vector<std::uint64_t> low(n, 0);
  std::vector<std::uint64_t> high(n, std::uint64_t{1} << bits);
  for (int step = 0; step < bits; ++step) {
    std::vector<std::int64_t> found(n);
    for (std::size_t t = 0; t < n; ++t) found[t] = below(low[t] + (high[t] - low[t]) / 2);
    ranks.sum(found.data(), n);
    for (std::size_t t = 0; t < n; ++t) {
      const std::uint64_t middle = low[t] + (high[t] - low[t]) / 2;
      (found[t] <= targets[t] ? low[t] : high[t]) = middle;
    }
  }
  return low;
}

/// Number of ascending keys below one.
inline std::int64_t count_below(const std::vector<std::uint64_t>& keys, std::uint64_t key) {
  return std::lower_bound(keys.begin(), keys.end(), key) - keys.begin();
}

/// Of the keys above `low` up to `high` the one that ends in the most zeros. The curve enters the largest of its squares or
/// cubes there, so that the parts before and behind it meet in the smallest area.
inline std::uint64_t roundest_key(std::uint64_t low, std::uint64_t high) {
  const auto differ = static_cast<int>(std::bit_width(low ^ high));  // high has the first of these bits, low has not
  return differ == 0 ? high : high >> (differ - 1) << (differ - 1);
}

/// A rank may have more or less than its share of the cost by so much at either end of its range, for ranges that meet in
/// small areas.
inline constexpr double share_slack = 0.02;

/// Ranges of about equal cost; the walls' begin where the fluid's do in space.
inline Cut cut_by_weight(Ranks& ranks, const SortedKeys& keys, int bits) {
  std::vector<std::int64_t> before(keys.weight.size() + 1, 0);
  for (std::size_t i = 0; i < keys.weight.size(); ++i) before[i + 1] = before[i] + keys.weight[i];
  std::int64_t totals[] = {before.back(), static_cast<std::int64_t>(keys.fluid.size()),
                           static_cast<std::int64_t>(keys.walls.size())};
  ranks.sum(totals, 3);
  const std::int64_t share = totals[0] / ranks.size();
  const std::int64_t slack = std::llround(share_slack * static_cast<double>(share));
  std::vector<std::int64_t> targets;
  for (int r = 1; r < ranks.size(); ++r) targets.insert(targets.end(), {share * r - slack, share * r + slack});
  const auto between = split_keys(ranks, targets, bits, [&](std::uint64_t key) {
    return before[static_cast<std::size_t>(count_below(keys.fluid, key))];
  });
  std::vector<std::uint64_t> split;
  for (std::size_t t = 0; t < between.size(); t += 2) split.push_back(roundest_key(between[t], between[t + 1]));
  const std::size_t n = split.size();
  std::vector<std::int64_t> counts(2 * n);
  const std::uint64_t behind_fluid = std::uint64_t{1}
                                     << (bits - 2);  // the bit that parts walls from fluid (HilbertKey)
  for (std::size_t t = 0; t < n; ++t) {
    counts[t] = count_below(keys.fluid, split[t]);
    counts[n + t] = count_below(keys.walls, split[t] | behind_fluid);
  }
  ranks.sum(counts.data(), counts.size());
  Cut cut{{0}, {0}};
  for (std::size_t t = 0; t < n; ++t) {
    const std::int64_t blocks = (counts[t] + sum_block / 2) / sum_block * sum_block;
    cut.fluid.push_back(std::max(cut.fluid.back(), std::min(blocks, totals[1] / sum_block * sum_block)));
    cut.walls.push_back(std::max(cut.walls.back(), counts[n + t] / wall_group * wall_group));
  }
  cut.fluid.push_back(totals[1]);
  cut.walls.push_back(totals[2]);
  return cut;
}

/// Cuts of this rank's ascending keys, so that the ranks' ranges begin at given positions of the global order. Equal keys
/// stand in the order of the ranks that have them.
inline std::vector<Index> cut_here(Ranks& ranks, const std::vector<std::uint64_t>& keys,
                                   const std::vector<std::int64_t>& positions, int bits) {
  const std::vector<std::int64_t> inner(positions.begin() + 1, positions.end() - 1);
  const auto split = split_keys(ranks, inner, bits, [&](std::uint64_t key) { return count_below(keys, key); });
  const std::size_t n = split.size();
  std::vector<std::int64_t> mine(2 * n);  // below the key, and equal to it
  for (std::size_t t = 0; t < n; ++t) {
    mine[t] = count_below(keys, split[t]);
    mine[n + t] = count_below(keys, split[t] + 1) - mine[t];
  }
  std::vector<std::int64_t> all(mine.size() * static_cast<std::size_t>(ranks.size()));
  if (n > 0) ranks.gather(mine.data(), mine.size() * sizeof(std::int64_t), all.data());
  std::vector<Index> at{0};
  for (std::size_t t = 0; t < n; ++t) {
    std::int64_t of_equal = inner[t];  // so many of those with this key belong before the cut
    for (int r = 0; r < ranks.size(); ++r) of_equal -= all[static_cast<std::size_t>(r) * 2 * n + t];
    for (int r = 0; r < ranks.rank(); ++r) of_equal -= all[static_cast<std::size_t>(r) * 2 * n + n + t];
    at.push_back(static_cast<Index>(mine[t] + std::clamp<std::int64_t>(of_equal, 0, mine[n + t])));
  }
  at.push_back(static_cast<Index>(keys.size()));
  return at;
}

/// The particles that change their rank, and the order in which those that come stand among those that stay.
class Handover {
 public:
  Handover(Ranks& ranks, const SortedKeys& keys, const Cut& cut, int bits)
      : ranks_(ranks),
        fluid_(cut_here(ranks, keys.fluid, cut.fluid, bits)),
        walls_(cut_here(ranks, keys.walls, cut.walls, bits)) {
    const auto me = static_cast<std::size_t>(ranks.rank());
    const std::size_t stays = fluid_[me + 1] - fluid_[me] + walls_[me + 1] - walls_[me];
    std::int64_t moving = static_cast<std::int64_t>(keys.fluid.size() + keys.walls.size() - stays);
    ranks.sum(&moving, 1);
    moving_ = moving;
    if (moving_ == 0) return;
    const auto n = static_cast<std::size_t>(ranks.size());
    std::vector<Bytes> to(n);
    for (std::size_t r = 0; r < n; ++r) {
      const Index counts[] = {fluid_[r + 1] - fluid_[r], walls_[r + 1] - walls_[r]};
      append_to(to[r], counts, 2);
      append_to(to[r], keys.fluid.data() + fluid_[r], counts[0]);
      append_to(to[r], keys.walls.data() + walls_[r], counts[1]);
    }
    const auto from = exchange_any(ranks, to);
    std::vector<std::vector<std::uint64_t>> fluid(n);
    std::vector<std::vector<std::uint64_t>> walls(n);
    for (std::size_t r = 0; r < n; ++r) {
      MessageReader message(from[r]);
      Index counts[2];
      message.read(counts, 2);
      fluid[r].resize(counts[0]);
      walls[r].resize(counts[1]);
      message.read(fluid[r].data(), counts[0]);
      message.read(walls[r].data(), counts[1]);
    }
    place_.resize(n);
    new_fluid_ = merge(fluid, 0);
    new_count_ = merge(walls, new_fluid_);
    for (const auto& of_rank : fluid) fluid_from_.push_back(static_cast<Index>(of_rank.size()));
  }

  [[nodiscard]] bool anything_moves() const { return moving_ != 0; }

  /// Hands over all arrays that follow their particles.
  template <int Dim, class Device>
  void apply(Device& on, Particles<Device>& p, const Scene<Dim>& scene) const {
    const auto n = static_cast<std::size_t>(ranks_.size());
    std::vector<Bytes> to(n);
    const auto pack = [&](auto& buffer) {
      const auto entries = on.download(buffer, 0, p.count);
      for (std::size_t r = 0; r < n; ++r) {
        if (static_cast<int>(r) == ranks_.rank()) continue;
        append_to(to[r], entries.data() + fluid_[r], fluid_[r + 1] - fluid_[r]);
        append_to(to[r], entries.data() + p.fluid_count + walls_[r], walls_[r + 1] - walls_[r]);
      }
    };
    pack(p.record);
    EachArray pack_arrays(sorted, [&](const Field&, auto& buffer, const auto&) { pack(buffer); });
    p.describe(scene, pack_arrays);
    const auto from = exchange_any(ranks_, to);
    std::vector<MessageReader> readers(from.begin(), from.end());
    const auto unpack = [&](auto& buffer) {
      using T = std::remove_cvref_t<decltype(*buffer.data())>;
      HostBuffer<T> entries(new_count_);
      {
        const auto old = on.download(buffer, 0, p.count);
        for (std::size_t r = 0; r < n; ++r) {
          if (static_cast<int>(r) == ranks_.rank()) {
            place(r, old.data() + fluid_[r], old.data() + p.fluid_count + walls_[r], entries);
          } else {
            std::vector<T> came(place_[r].size());
            readers[r].read(came.data(), came.size());
            place(r, came.data(), came.data() + fluid_from_[r], entries);
          }
        }
      }
      on.upload(std::move(entries), buffer);
    };
    unpack(p.record);
    EachArray unpack_arrays(sorted, [&](const Field&, auto& buffer, const auto&) { unpack(buffer); });
    p.describe(scene, unpack_arrays);
    p.count = new_count_;
    p.fluid_count = new_fluid_;
    p.record.resize(std::size_t{p.count} + 1);
    on.write(Record{}, p.record.data() + p.count);
  }

 private:
  /// Notes where those that come from each rank stand; returns the first place behind them.
  Index merge(const std::vector<std::vector<std::uint64_t>>& keys, Index first) {
    struct Comer {
      std::uint64_t key;
      Index rank;
    };
    std::vector<Comer> order;
    for (std::size_t r = 0; r < keys.size(); ++r) {
      const auto middle = static_cast<std::ptrdiff_t>(order.size());
      for (const std::uint64_t key : keys[r]) order.push_back({key, static_cast<Index>(r)});
      std::inplace_merge(order.begin(), order.begin() + middle, order.end(),
                         [](const Comer& a, const Comer& b) { return a.key < b.key; });
    }
    for (std::size_t n = 0; n < order.size(); ++n) place_[order[n].rank].push_back(first + static_cast<Index>(n));
    return first + static_cast<Index>(order.size());
  }

  /// Writes a rank's fluid and walls to their places.
  template <class T>
  void place(std::size_t r, const T* fluid, const T* walls, HostBuffer<T>& to) const {
    const std::vector<Index>& at = place_[r];
    for (Index n = 0; n < fluid_from_[r]; ++n) to[at[n]] = fluid[n];
    for (auto n = std::size_t{fluid_from_[r]}; n < at.size(); ++n) to[at[n]] = walls[n - fluid_from_[r]];
  }

  Ranks& ranks_;
  std::vector<Index> fluid_;  // where this rank's fluid is cut
  std::vector<Index> walls_;
  std::int64_t moving_ = 0;  // on all ranks
  Index new_count_ = 0;
  Index new_fluid_ = 0;
  std::vector<std::vector<Index>> place_;  // of those that come from each rank, fluid first
  std::vector<Index> fluid_from_;          // so many of them are fluid
};

}  // namespace thalweg
