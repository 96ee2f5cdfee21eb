#pragma once

#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// The top of the wall that each wall particle belongs to. The wall is cut into columns one spacing wide; within a
/// column, particles closer than two spacings form one run (nothing fits between them), and so do the shells of a solid that is
/// hollow inside (wall_gaps.hpp).
struct WallRuns {
  std::vector<double> top;  // [m] per particle of the set: highest point of its run; NaN for particles that are no wall

  /// Wall particles that stand where another one stands, and count as nothing: rows that a bed that is a surface keeps ready
  /// below a bare floor.
  std::vector<char> doubled;

  double open_from = -std::numeric_limits<double>::infinity();  // [m] the flow lies between the outermost columns
  double open_to = std::numeric_limits<double>::infinity();     // [m] whose wall is lower than the highest wall

  /// The tops of the walls that move in and beside a column [m]. They carry no bed.
  [[nodiscard]] std::vector<double> moving_tops(double x, double y) const;
  /// The top of the lowest wall of a column [m]; NaN without a wall, and where a wall moves in it.
  [[nodiscard]] double floor(double x, double y) const;

  struct Column {
    double floor = 0;                   // [m] top of its lowest run
    std::vector<double> moving_tops{};  // [m] of its runs that move
  };
  double spacing = 0;                                 // [m]
  std::map<std::pair<long, long>, Column> columns{};  // by x and y in spacings
};

/// Finds the runs of all fixed and moving walls of `particles`; `spacing` [m].
WallRuns find_wall_runs(const ParticleSet& particles, double spacing);

}  // namespace thalweg
