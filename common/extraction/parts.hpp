#pragma once

#include <cstdint>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

[[nodiscard]] inline bool is_wall(ParticleType type) {
  return type == ParticleType::wall || type == ParticleType::moving_wall;
}
[[nodiscard]] inline bool is_fluid(ParticleType type) { return !is_wall(type); }

/// The kernel sum to which a particle contributes.
enum class Part : std::uint8_t { water, moving_sediment, resting_sediment, wall };

/// The part of every particle. Sediment rests if it is slower than `rest_speed` [m/s] and, in a set with states, is a
/// deposit. Without states and velocities no sediment rests.
std::vector<Part> parts_of(const ParticleSet& particles, double rest_speed);

/// True if some sediment particle has a state, so that the states tell which sediment rests.
bool has_sediment_states(const ParticleSet& particles);
/// True if the set holds sediment.
bool holds_sediment(const ParticleSet& particles);
/// True if the set holds sediment and tells which of it rests, by states or by velocities.
bool knows_rest(const ParticleSet& particles);

}  // namespace thalweg
