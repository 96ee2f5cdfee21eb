#pragma once

#include <vector>

#include "common/case.hpp"
#include "solver/wall_motion.hpp"

namespace thalweg {

/// The motions of a case in its order, each counted from where it is at t = 0.
std::vector<WallMotion> make_motions(const Case& from);

/// Largest speed of the walls among `particles` until the time `end` [s], [m/s]; of an oscillation its peak's.
double largest_wall_speed(const std::vector<WallMotion>& motions, const ParticleSet& particles, double end);

}  // namespace thalweg
