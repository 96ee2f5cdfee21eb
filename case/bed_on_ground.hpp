#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// Throws InputError for a bed that is a surface if sediment hangs over water or over a wall: it is one layer of columns
/// on the lowest fluid over each place of the ground. `particles` are those of a filled scene.
void require_bed_on_ground(const Case& of, const ParticleSet& particles);

}  // namespace thalweg
