#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/particle_arrays.hpp"
#include "common/particles.hpp"
#include "solver/domain/population.hpp"
#include "solver/lists/cut.hpp"
#include "solver/models/wall_stress/find_elements.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/load.hpp"
#include "solver/state/cluster_list.hpp"

// Which particles of a file each of several ranks begins with.
namespace thalweg {

/// Particles [first, second) of a file.
using FileRange = std::pair<std::size_t, std::size_t>;

/// A filled scene is dealt out as the file has it, in whole blocks of sums, so that sums over all particles have the same
/// bits whatever the number of ranks. The particles of a checkpoint stand in the order of the lists: each rank has a
/// range of the fluid and one of the walls. `n`: particles of the file, `fluid`: of these, if they are in order.
inline std::vector<FileRange> ranges_of_rank(std::size_t n, std::optional<std::size_t> fluid, int rank, int ranks) {
  if (fluid) {
    const Cut cut = cut_evenly(static_cast<std::int64_t>(*fluid), static_cast<std::int64_t>(n - *fluid), ranks);
    const auto r = static_cast<std::size_t>(rank);
    return {{static_cast<std::size_t>(cut.fluid[r]), static_cast<std::size_t>(cut.fluid[r + 1])},
            {*fluid + static_cast<std::size_t>(cut.walls[r]), *fluid + static_cast<std::size_t>(cut.walls[r + 1])}};
  }
  const auto begin = [&](int of) {
    if (of == ranks) return n;
    return n * static_cast<std::size_t>(of) / static_cast<std::size_t>(ranks) / sum_block * sum_block;
  };
  return {{begin(rank), begin(rank + 1)}};
}

/// The particles that a rank begins with, and the block of sums in which they do.
struct DealtShare {
  ParticleSet particles;
  std::int64_t first_block = 0;
};

/// Deals the particles of a filled scene or of a checkpoint out to ranks. What the whole file tells, the shares are told
/// too: the elements of walls, and the ids that are taken.
template <int Dim>
class Deal {
 public:
  /// `all` is kept by reference.
  Deal(const Scene<Dim>& scene, const ParticleSet& all, int ranks) : all_(all), ranks_(ranks) {
    in_order_ = all.doubles.contains(checkpoint_array::listed_at);
    for (std::size_t i = 0; in_order_ && i < all.size(); ++i) fluid_ += kind_of(scene, all, i) == kind::wall ? 0 : 1;
    Population::of(all).add_to(known_);
    if (!scene.wall_stress.on || all.doubles.contains(field::wall_element.name)) return;
    elements_ = WallElementFinder<Dim>(scene, all).find();
  }

  [[nodiscard]] DealtShare share(int rank) const {
    const std::vector<FileRange> ranges = ranges_of(rank);
    DealtShare dealt;
    dealt.first_block = static_cast<std::int64_t>(ranges.front().first / sum_block);
    ParticleSet& part = dealt.particles;
    part.info = all_.info;
    part.facts = all_.facts;
    for (const auto& [name, numbers] : known_.facts) part.facts[name] = numbers;
    for_each_array(part, [&](const char* name, auto& array) {
      for_each_array(all_, [&](const char* other, const auto& of_all) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(of_all)>, std::remove_cvref_t<decltype(array)>>) {
          if (std::string_view(name) == other) array = chosen(ranges, of_all);
        }
      });
    });
    part.position = chosen(ranges, all_.position);
    for (const auto& [name, array] : all_.scalars) part.scalars[name] = chosen(ranges, array);
    for (const auto& [name, array] : all_.doubles) part.doubles[name] = chosen(ranges, array);
    if (elements_.empty()) return dealt;
    std::vector<double>& numbers = part.doubles[field::wall_element.name];
    for (const auto& [from, to] : ranges) {
      for (std::size_t i = from; i < to; ++i) {
        numbers.resize(numbers.size() + numbers_in<WallElement>());
        encode(elements_[i], &numbers[numbers.size() - numbers_in<WallElement>()]);
      }
    }
    return dealt;
  }

 private:
  [[nodiscard]] std::vector<FileRange> ranges_of(int rank) const {
    return ranges_of_rank(all_.size(), in_order_ ? std::make_optional(fluid_) : std::nullopt, rank, ranks_);
  }

  /// The entries of an array with one or more for each particle of the file.
  template <class Array>
  [[nodiscard]] Array chosen(const std::vector<FileRange>& ranges, const Array& of_all) const {
    Array chosen;
    if (of_all.empty()) return chosen;
    const std::size_t each = of_all.size() / all_.size();
    for (const auto& [from, to] : ranges) {
      chosen.insert(chosen.end(), of_all.begin() + static_cast<std::ptrdiff_t>(from * each),
                    of_all.begin() + static_cast<std::ptrdiff_t>(to * each));
    }
    return chosen;
  }

  const ParticleSet& all_;
  int ranks_;
  bool in_order_ = false;
  std::size_t fluid_ = 0;  // of a file in order
  ParticleSet known_;      // facts that hold for the whole file
  HostBuffer<WallElement> elements_;
};

}  // namespace thalweg
