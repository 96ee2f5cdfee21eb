#pragma once

#include <vector>

#include "common/case.hpp"
#include "solver/wall_motion.hpp"

namespace thalweg {

/// The motions of a case in its order, each counted from where it is at t = 0.
std::vector<WallMotion> make_motions(const Case& from);

}  // namespace thalweg
