#pragma once

#include "common/particles.hpp"

namespace thalweg {

/// The particles whose place `keep(position)` accepts, with what the extraction of levels reads: type, state, position,
/// velocity, mass and density.
template <class Keep>
ParticleSet subset(const ParticleSet& particles, Keep&& keep) {
  ParticleSet kept;
  kept.info = particles.info;
  const auto take = [](auto& to, const auto& from, std::size_t i) {
    if (!from.empty()) to.push_back(from[i]);
  };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!keep(particles.position[i])) continue;
    kept.id.push_back(particles.id[i]);
    kept.type.push_back(particles.type[i]);
    kept.position.push_back(particles.position[i]);
    take(kept.state, particles.state, i);
    take(kept.velocity, particles.velocity, i);
    take(kept.density, particles.density, i);
    take(kept.mass, particles.mass, i);
  }
  return kept;
}

}  // namespace thalweg
