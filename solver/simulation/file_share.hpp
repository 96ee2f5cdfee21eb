#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/particle_arrays.hpp"
#include "common/particles.hpp"
#include "common/ranks.hpp"
#include "solver/lists/cut.hpp"
#include "solver/state/cluster_list.hpp"

// Which particles of a file a rank begins with. Only these reach its device.
namespace thalweg {

/// Particles [first, second) of a file.
using FileRange = std::pair<std::size_t, std::size_t>;

/// The ranges of a file's n particles that a rank begins with. They stand as the file has them: whole blocks of sums, so
/// that sums over all particles have the same bits whatever the number of ranks.
inline std::vector<FileRange> even_ranges(const Ranks& ranks, std::size_t n) {
  const auto begin = [&](int rank) {
    if (rank == ranks.size()) return n;
    return n * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks.size()) / sum_block * sum_block;
  };
  return {{begin(ranks.rank()), begin(ranks.rank() + 1)}};
}

/// The ranges of a checkpoint, in which n particles, `fluid` of them, stand in the order of the lists: one of the fluid and
/// one of the walls.
inline std::vector<FileRange> ranges_in_order(const Ranks& ranks, std::size_t n, std::size_t fluid) {
  const Cut cut = cut_evenly(static_cast<std::int64_t>(fluid), static_cast<std::int64_t>(n - fluid), ranks.size());
  const auto r = static_cast<std::size_t>(ranks.rank());
  return {{static_cast<std::size_t>(cut.fluid[r]), static_cast<std::size_t>(cut.fluid[r + 1])},
          {fluid + static_cast<std::size_t>(cut.walls[r]), fluid + static_cast<std::size_t>(cut.walls[r + 1])}};
}

/// The particles of a file, and those of them that this rank begins with.
class FileShare {
 public:
  /// One rank has all. `all` is kept by reference.
  explicit FileShare(const ParticleSet& all) : all_(all) {}
  FileShare(const ParticleSet& all, std::vector<FileRange> ranges) : all_(all), ranges_(std::move(ranges)) {
    part_.info = all.info;
    part_.facts = all.facts;
    for_each_array(part_, [&](const char* name, auto& array) {
      for_each_array(all, [&](const char* other, const auto& of_all) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(of_all)>, std::remove_cvref_t<decltype(array)>>) {
          if (std::string_view(name) == other) array = chosen(of_all);
        }
      });
    });
    part_.position = chosen(all.position);
    for (const auto& [name, array] : all.scalars) part_.scalars[name] = chosen(array);
    for (const auto& [name, array] : all.doubles) part_.doubles[name] = chosen(array);
  }

  [[nodiscard]] const ParticleSet& all() const { return all_; }
  [[nodiscard]] const ParticleSet& mine() const { return ranges_.empty() ? all_ : part_; }
  /// The block of sums in which they begin.
  [[nodiscard]] std::int64_t first_block() const {
    return ranges_.empty() ? 0 : static_cast<std::int64_t>(ranges_.front().first / sum_block);
  }

  /// This rank's entries of an array with one or more for each particle of the file.
  template <class Array>
  [[nodiscard]] Array mine_of(Array of_all) const {
    return ranges_.empty() ? std::move(of_all) : chosen(of_all);
  }

 private:
  template <class Array>
  [[nodiscard]] Array chosen(const Array& of_all) const {
    Array chosen;
    if (of_all.empty()) return chosen;
    const std::size_t each = of_all.size() / all_.size();
    for (const auto& [from, to] : ranges_) {
      chosen.insert(chosen.end(), of_all.begin() + static_cast<std::ptrdiff_t>(from * each),
                    of_all.begin() + static_cast<std::ptrdiff_t>(to * each));
    }
    return chosen;
  }

  const ParticleSet& all_;
  std::vector<FileRange> ranges_;  // none: all
  ParticleSet part_;
};

}  // namespace thalweg
