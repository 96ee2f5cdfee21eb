#pragma once

#include <vector>

#include "case/case.hpp"
#include "solver/models/moving_walls/wall_motion.hpp"

namespace thalweg {

/// The motions of a case in its order, each counted from where it is at t = 0.
std::vector<WallMotion> make_motions(const Case& from);

/// Largest speed of the walls among `particles` until the time `end` [s], [m/s]; of an oscillation its peak's.
double largest_wall_speed(const std::vector<WallMotion>& motions, const ParticleSet& particles, double end);

}  // namespace thalweg
