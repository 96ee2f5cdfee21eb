#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <vector>

#include "solver/models/openings/zone.hpp"

// The particles that an inlet holds ready. They stand in columns along the flow, a spacing apart, and a column above
// another in rows. Water whose level lies between two rows comes in with particles of less or more mass in the highest
// row. With whole ones an inlet brought its discharge through ten rows or through eleven, a tenth slower, and stayed at
// either, because the depth next to it is the one that it makes.
namespace thalweg {

/// One column of an inlet's zone: particles one behind the other, a spacing apart.
struct InletColumn {
  double up = 0;       // [m] of its axis, from the centre of the opening
  double across = 0;   // [m]
  bool exists = true;  // false: it lies outside of a round opening
  bool is_full = false;
  double share = 1;           // [-] height of the newborn's water over that of the cell
  double area = 0;            // [m^2] cross-section of its particles' water (2-D: [m])
  double phase = 0;           // [m] way of its first particle since the one before it crossed the plane
  std::deque<double> masses;  // [kg] of its particles, the next that crosses the plane first

  [[nodiscard]] double mass() const { return std::accumulate(masses.begin(), masses.end(), 0.0); }

  /// Particles that are there were born with other shares than the next one. cell: area of a full column; weight: of a
  /// slice of the water, as thick as the columns' spacing, per area [kg/m^2] (2-D: [kg/m]).
  void set_area(double cell, double weight) {
    area = is_full ? cell * share : 0;
    if (!masses.empty()) area = mass() / (weight * static_cast<double>(masses.size()));
  }
};

/// The columns of an inlet's zone, row by row.
inline std::vector<InletColumn> inlet_columns(const Zone& zone, int dimension) {
  const double high = 2 * zone.half_up / zone.rows;
  const double wide = 2 * zone.half_across / zone.ranks;
  std::vector<InletColumn> columns;
  for (Index row = 0; row < zone.rows; ++row) {
    for (Index rank = 0; rank < zone.ranks; ++rank) {
      InletColumn column;
      column.up = (row + 0.5) * high - zone.half_up;
      column.across = dimension == 3 ? (rank + 0.5) * wide - zone.half_across : 0;
      if (zone.round) column.exists = std::hypot(column.up, column.across) <= zone.half_up;
      columns.push_back(column);
    }
  }
  return columns;
}

/// Number of an inlet's rows with water, up to the highest; `ranks` columns in each.
inline Index rows_with_water(const InletColumn* columns, std::size_t count, Index ranks) {
  std::size_t rows = 0;
  for (std::size_t c = 0; c < count; ++c) {
    if (columns[c].is_full) rows = c / static_cast<std::size_t>(ranks) + 1;
  }
  return static_cast<Index>(rows);
}

/// The highest row takes the water up to the level, 0.5 to 1.5 rows. A row more or less comes when the level is past that
/// by this share of a row: a level that moves little does not switch rows on and off.
inline constexpr double row_slack = 0.15;

/// Number of rows that water fills up to a level [rows over the lower edge]: `before` of them until now, `all` at most.
inline Index rows_up_to(double level, Index before, Index all) {
  const double highest = level - (before - 1);
  if (before > 0 && highest > 0.5 - row_slack && highest < 1.5 + row_slack) return before;
  return static_cast<Index>(std::clamp(std::floor(level + 0.5 + 1e-6), 0.0, double(all)));
}

/// Height of the water in the highest of some rows [rows].
inline double share_of_highest(double level, Index rows) {
  return std::clamp(level - (rows - 1), 0.5 - row_slack, 1.5 + row_slack);
}

}  // namespace thalweg
