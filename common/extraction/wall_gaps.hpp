#pragma once

#include <map>
#include <utility>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// One run of a column of wall: particles without room for another between them.
struct WallRun {
  double low = 0;           // [m] lower side of its lowest particle
  double high = 0;          // [m] upper side of its highest
  std::size_t members = 0;  // particles of the column up to its highest one
};

/// The runs of the columns of wall, from the lowest to the highest in each, by the columns' places in spacings.
using RunsOfColumns = std::map<std::pair<long, long>, std::vector<WallRun>>;

/// Joins runs of one solid. Gencase keeps of a thick wall a shell along each of its faces, so that a floor is two runs
/// with a hollow between them. A gap between two runs is room of the flow if fluid is in it, or if it is connected, within
/// the outermost columns, to what lies over the walls; else the runs below and above it become one. Walls scattered far
/// apart stay as they are. spacing [m].
void join_hollow_walls(const ParticleSet& particles, double spacing, RunsOfColumns& columns);

/// Column of a coordinate [m], one spacing [m] wide. They are counted from half a spacing, so that rounding never splits the
/// particles of one column of a lattice anchored at multiples of the spacing (or half of it).
long column_of(double coordinate, double spacing);

}  // namespace thalweg
