#include "common/extraction/parts.hpp"

#include <algorithm>

namespace thalweg {

std::vector<Part> parts_of(const ParticleSet& particles, double rest_speed) {
  const bool states = has_sediment_states(particles);
  const auto rests = [&](std::size_t i) {
    if (states && particles.state[i] != SedimentState::deposit) return false;
    if (particles.velocity.empty()) return states;
    return particles.velocity[i].norm() < rest_speed;
  };
  std::vector<Part> parts(particles.size(), Part::water);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    switch (particles.type[i]) {
      case ParticleType::wall:
      case ParticleType::moving_wall:
        parts[i] = Part::wall;
        break;
      case ParticleType::water:
        break;
      case ParticleType::sediment:
        parts[i] = rests(i) ? Part::resting_sediment : Part::moving_sediment;
        break;
    }
  }
  return parts;
}

bool has_sediment_states(const ParticleSet& particles) {
  for (std::size_t i = 0; i < particles.state.size(); ++i) {
    if (particles.type[i] == ParticleType::sediment && particles.state[i] != SedimentState::none) return true;
  }
  return false;
}

bool holds_sediment(const ParticleSet& particles) {
  return std::find(particles.type.begin(), particles.type.end(), ParticleType::sediment) != particles.type.end();
}

bool knows_rest(const ParticleSet& particles) {
  return holds_sediment(particles) && (has_sediment_states(particles) || !particles.velocity.empty());
}

}  // namespace thalweg
