#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "common/extraction/bodies.hpp"

namespace thalweg {

/// The heights of all columns of a grid [m], NaN where there is nothing; in 2-D a single row of columns.
struct LevelMap {
  SamplingGrid grid;
  std::vector<ColumnLevels> levels;  // SamplingGrid::column

  /// Height of the bed (or of the sediment at rest) between columns, linear in x and y. The columns of a cell that have none
  /// count for nothing; NaN where these are more than half. Where all are dry, the floor.
  [[nodiscard]] double at(double ColumnLevels::*height, double x, double y) const;
  /// The same node's levels, if the map has it; `like` has the map's step.
  [[nodiscard]] const ColumnLevels* find(const SamplingGrid& like, std::size_t i, std::size_t j) const;
};

/// The change of the bed between two maps. The bed is what sediment lies on: a column counts if sediment lies in it, a layer
/// at least, before or after, on the same wall, which does not move. Volumes are per metre of width in 2-D [m^2].
struct BedBalance {
  double scour = 0;  // [m] deepest fall of the bed, >= 0: the scour depth
  Vec3 scour_at = Vec3::Zero();
  double deposition = 0;  // [m] highest rise, >= 0
  Vec3 deposition_at = Vec3::Zero();
  double resting_scour = std::numeric_limits<double>::quiet_NaN();  // [m] of the sediment at rest; NaN if unknown
  Vec3 resting_scour_at = Vec3::Zero();
  double eroded = 0;           // [m^3] where the bed fell
  double deposited = 0;        // [m^3] where it rose
  double sediment_volume = 0;  // [m^3] of `after`, between bed and floor
};

/// Heights of one column of a bed at two times [m]; NaN where no sediment lies before or after, where the walls below
/// differ, and inside walls.
struct BedHeights {
  double before = std::numeric_limits<double>::quiet_NaN();
  double now = std::numeric_limits<double>::quiet_NaN();
};

/// The bed of every column of `after` at both times, by the rules of BedBalance.
std::vector<BedHeights> bed_heights(const LevelMap& before, const LevelMap& after);

/// Compares two maps at the columns both have; nothing when they share none. Volumes are sums over the cells whose
/// columns all have heights (trapezoidal rule).
std::optional<BedBalance> bed_balance(const LevelMap& before, const LevelMap& after);

}  // namespace thalweg
