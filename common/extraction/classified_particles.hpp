#pragma once

#include <vector>

#include "common/extraction/parts.hpp"
#include "common/extraction/wall_runs.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// A particle set and what every kernel sum over it has to know of the particles. It is found once, however many grids
/// are filled from the set.
struct ClassifiedParticles {
  /// Refers to `set`, which must outlive it. `rest_speed` [m/s] as in parts_of(). Throws InputError if the set does not
  /// say its spacing and smoothing length.
  ClassifiedParticles(const ParticleSet& set, double rest_speed);

  const ParticleSet& particles;
  std::vector<Part> parts;  // of each particle
  WallRuns walls;
  bool has_sediment;
  bool rest_is_known;  // the set tells which sediment rests
};

}  // namespace thalweg
