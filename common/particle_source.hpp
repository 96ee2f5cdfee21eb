#pragma once

#include <algorithm>
#include <cstdint>

#include "common/particles.hpp"

namespace thalweg {

/// Particles that are read range by range, as often as needed.
class ParticleSource {
 public:
  virtual ~ParticleSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Info and facts, without particles.
  [[nodiscard]] virtual const ParticleSet& frame() const = 0;
  /// Particles [from, to), with info and facts. Throws InputError.
  virtual ParticleSet range(std::uint64_t from, std::uint64_t to) = 0;
};

/// Particles that are read at a time: some megabytes.
inline constexpr std::uint64_t particles_at_once = std::uint64_t{1} << 15;

}  // namespace thalweg
