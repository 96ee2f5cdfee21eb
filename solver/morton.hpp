#pragma once

#include <cstdint>

#include "solver/physics/vec.hpp"

namespace thalweg {

/// Bits of x spread to every second (stride 2) or third (stride 3) place: the standard shift-and-mask interleave.
HOST_DEVICE inline std::uint64_t spread_by_two(std::uint64_t x) {
  x &= 0x7fffffff;
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}
HOST_DEVICE inline std::uint64_t spread_by_three(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Position along the Morton (Z) curve: 2 x 31 or 3 x 21 bits, so that the top two bits stay free.
template <int Dim>
HOST_DEVICE inline std::uint64_t morton_code(const Vec<Dim, std::uint32_t>& cell) {
  if constexpr (Dim == 2) {
    return spread_by_two(cell[0]) | spread_by_two(cell[1]) << 1;
  } else {
    return spread_by_three(cell[0]) | spread_by_three(cell[1]) << 1 | spread_by_three(cell[2]) << 2;
  }
}

}  // namespace thalweg
