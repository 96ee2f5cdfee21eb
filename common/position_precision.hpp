#pragma once

#include <limits>

namespace thalweg {

/// Precision of the positions in a particle file: single for snapshots, which are looked at, double for particles.vtp
/// and checkpoints, from which a run goes on.
enum class PositionPrecision { single_precision, double_precision };

/// The precision that positions need: far from the origin (a UTM easting, a river's chainage) single precision cannot tell a
/// hundredth of the spacing. `farthest`: the largest coordinate, `spacing`: 0 if unknown [m].
inline PositionPrecision sufficient_precision(PositionPrecision asked, double farthest, double spacing) {
  const double rounding = 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon()) * farthest;
  return rounding > 0.01 * spacing && spacing > 0 ? PositionPrecision::double_precision : asked;
}

}  // namespace thalweg
