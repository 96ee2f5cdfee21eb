#pragma once

#include <limits>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// The top of the wall that each wall particle belongs to. The wall is cut into columns one spacing wide; within a
/// column, particles closer than two spacings form one run (nothing fits between them).
struct WallRuns {
  std::vector<double> top;  // [m] per particle of the set: highest point of its run; NaN for particles that are no wall

  double open_from = -std::numeric_limits<double>::infinity();  // [m] the flow lies between the outermost columns
  double open_to = std::numeric_limits<double>::infinity();     // [m] whose wall is lower than the highest wall
};

/// Finds the runs of all fixed and moving walls of `particles`; `spacing` [m].
WallRuns find_wall_runs(const ParticleSet& particles, double spacing);

}  // namespace thalweg
