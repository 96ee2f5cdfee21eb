#pragma once

#include <map>
#include <optional>
#include <vector>

#include "common/extraction/connected_body.hpp"

namespace thalweg {

/// Layers thinner than this share of the spacing count as absent: half of one layer of particles.
inline constexpr double least_layer = 0.5;

/// Heights in one column of a grid [m]; NaN where there is less than a layer of anything.
struct ColumnLevels {
  double free_surface = 0;
  double bed = 0;  // top of the sediment, moving or not, also below a pipe; the floor where bare; NaN on a moving wall
  double motionless_bed = 0;  // top of the sediment at rest; the floor where nothing rests; NaN on a wall that moves
  double floor = 0;           // the wall under the fluid; also where the column is empty, but for walls that move
};

/// A sheet of fluid over a gap is at least this many spacings wide; less is spray.
inline constexpr double least_sheet = 6;

/// The bodies connected to the floor: the fluid, the sediment in it, and the sediment at rest.
struct Bodies {
  /// `sums`, the sums over `set`, must outlive the bodies. The bodies of the sediment are left out if the set has none,
  /// and the resting one if the set does not tell which sediment rests. Fluid over `gap` [m] of air or less counts as
  /// standing on what is below (ConnectedBody), sediment does not.
  Bodies(const VolumeFractions& sums, const ClassifiedParticles& set, double gap = 0);

  [[nodiscard]] ColumnLevels levels(std::size_t column) const;

  double least_thickness;  // [m]
  ConnectedBody fluid;
  std::optional<ConnectedBody> sediment;
  std::optional<ConnectedBody> resting;

 private:
  [[nodiscard]] bool lies_on_moving_wall(std::size_t column, double height) const;

  std::vector<double> dry_floor_;                           // [m] of each column
  std::map<std::size_t, std::vector<double>> moving_tops_;  // [m] of walls that move, by column
  double spacing_;                                          // [m]
};

}  // namespace thalweg
