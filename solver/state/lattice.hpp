#pragma once

#include <cmath>
#include <cstdint>

#include "physics/vec.hpp"

namespace thalweg {

/// Whole-number coordinates of the domain. One direction's range is cut into 2^32 quanta; a place is a position in
/// quanta, kept in 32 bits. Differences of places are exact. In a periodic direction the range is the period, so that
/// unsigned wrap-around is the nearest-image rule; in any other it is twice the domain, so that nothing wraps.
/// At a domain of 3 m a quantum is 1.4 nm, 3e-7 of a 5 mm spacing.
template <int Dim>
struct Lattice {
  Vec<Dim, double> origin{};        // [m]
  Vec<Dim, double> range{};         // [m]
  Vec<Dim, float> quantum{};        // [m]
  Vec<Dim, std::uint32_t> cells{};  // list cells over the whole range, each at least `reach` wide
  bool periodic[Dim] = {};

  Lattice() = default;

  /// reach [m]: the smallest width a list cell may have.
  Lattice(const Vec<Dim, double>& from, const Vec<Dim, double>& to, const bool (&is_periodic)[Dim], double reach) {
    for (int k = 0; k < Dim; ++k) {
      periodic[k] = is_periodic[k];
      origin[k] = from[k];
      range[k] = (to[k] - from[k]) * (periodic[k] ? 1 : 2);
      quantum[k] = static_cast<float>(range[k] / 4294967296.0);
      cells[k] = static_cast<std::uint32_t>(std::fmax(1.0, std::floor(range[k] / reach)));
    }
  }

  HOST_DEVICE std::int32_t place(int k, double x) const {
    const double quanta = (x - origin[k]) * (4294967296.0 / range[k]);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(quanta + 0.5)));
  }

  /// a - b in quanta; around a period the shorter way.
  HOST_DEVICE static std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  }

  /// Which of `parts` equal parts of the range a place lies in.
  HOST_DEVICE static std::uint32_t part(std::int32_t place, std::uint64_t parts) {
    return static_cast<std::uint32_t>((static_cast<std::uint32_t>(place) * parts) >> 32);
  }
};

}  // namespace thalweg
