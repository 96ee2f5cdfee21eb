#pragma once

#include <cstddef>

#include "common/particles.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/models/wall_stress/arrays.hpp"
#include "solver/simulation/input.hpp"

namespace thalweg {

/// The elements of walls (wall_stress/find_elements.hpp) whose particles are read range by range, twice. They are found from all
/// walls, so that those are kept in between; the fluid is not.
class RangedWalls {
 public:
  /// The first reading. Particles that have their elements with them, as in a checkpoint, are passed over.
  void add(const ParticleSet& range);

  /// Finds the elements of a scene that has them. Throws InputError where a wall has no sides.
  void find(const AnyScene& scene);

  /// The second reading, in the same order: the particles are given their elements, if any were found.
  void give(ParticleSet& range);

 private:
  ParticleSet walls_;
  HostBuffer<WallElement> elements_;  // of the walls
  std::size_t next_ = 0;              // wall that is still to be given
};

}  // namespace thalweg
