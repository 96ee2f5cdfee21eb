#pragma once

#include "common/particles.hpp"

namespace thalweg {

/// Calls `visit(name, array)` for every array that is a member of ParticleSet, in the order of a particle file: the one
/// list of these arrays, for code that reads, writes or copies all of them. `name` is the array's name in the file
/// (docs/file-formats.md). Positions are left out, which a file holds as its points, and so are `scalars` and
/// `doubles`, which know their names. `Set` is ParticleSet or const ParticleSet.
template <class Set, class Visit>
void for_each_array(Set& set, Visit&& visit) {
  visit("Id", set.id);
  visit("Type", set.type);
  visit("State", set.state);
  visit("Velocity", set.velocity);
  visit("Density", set.density);
  visit("Pressure", set.pressure);
  visit("Mass", set.mass);
  visit("Viscosity", set.viscosity);
  visit("Normal", set.normal);
}

}  // namespace thalweg
