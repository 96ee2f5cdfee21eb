#pragma once

#include <cstdint>
#include <string>

#include "common/error.hpp"
#include "solver/state/cluster_list.hpp"

namespace thalweg {

/// The entries that neighbour lists can hold: their numbers have 32 bits.
inline constexpr std::uint64_t most_list_entries = UINT32_MAX - 2 * std::uint64_t{list_prefetch};

/// The number of entries as an Index. Throws InputError where it is too large for one.
inline Index countable_entries(std::uint64_t entries, std::uint64_t most = most_list_entries) {
  if (entries <= most) return static_cast<Index>(entries);
  throw InputError("the particles have " + std::to_string(entries) +
                   " entries in their neighbour lists and the lists can hold " + std::to_string(most) +
                   "; fill the scene with a larger spacing (numerics.spacing)");
}

}  // namespace thalweg
