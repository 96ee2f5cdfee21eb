#pragma once

#include <optional>

#include "common/extraction/connected_body.hpp"

namespace thalweg {

/// Layers thinner than this share of the spacing count as absent: half of one layer of particles.
inline constexpr double least_layer = 0.5;

/// Heights in one column of a grid [m]; NaN throughout where there is less than a layer of anything.
struct ColumnLevels {
  double free_surface = 0;
  double bed = 0;             // top of the sediment, moving or not; the floor where that is bare
  double motionless_bed = 0;  // top of the sediment at rest; the floor where nothing rests
  double floor = 0;           // the wall under the fluid; also where the column is empty
};

/// What is connected to the floor: the fluid, its sediment and what of that rests.
struct Bodies {
  /// `sums` must outlive the bodies. Without sediment, or without knowing what rests, those bodies are left out.
  Bodies(const VolumeFractions& sums, double spacing, bool has_sediment, bool knows_rest);

  [[nodiscard]] ColumnLevels levels(std::size_t column) const;

  double least_thickness;  // [m]
  ConnectedBody fluid;
  std::optional<ConnectedBody> sediment;
  std::optional<ConnectedBody> resting;
};

/// Whether the set holds sediment, and whether it says which of it rests.
bool holds_sediment(const ParticleSet& particles);
bool knows_rest(const ParticleSet& particles);

}  // namespace thalweg
