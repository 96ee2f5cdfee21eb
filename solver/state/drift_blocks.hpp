#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>

#include "solver/state/record.hpp"

namespace thalweg {

/// A box around the displacements of some particles since the lists were made [m], and the largest square of one [m^2],
/// which is infinite where a particle left the domain. An empty box has squared < 0.
struct DriftBox {
  float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX};
  float high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
  float squared = -1;

  HOST_DEVICE void add(const DriftBox& other) {
    for (int c = 0; c < 3; ++c) {
      low[c] = low[c] < other.low[c] ? low[c] : other.low[c];
      high[c] = high[c] > other.high[c] ? high[c] : other.high[c];
    }
    squared = squared > other.squared ? squared : other.squared;
  }
};

/// The domain in blocks two list cells wide, over the box of occupied ones (lists/drift.hpp). Directions are 0, 1, 2 of a
/// Vec<Dim>; a direction that a plane scene lacks has one block.
struct DriftBlocks {
  std::int64_t low[3] = {0, 0, 0};
  std::int64_t extent[3] = {1, 1, 1};
  std::int64_t period[3] = {0, 0, 0};  // blocks once around, 0 where the direction is not periodic
  /// Particles in blocks further apart than this are more than two list cells from each other. The last block around
  /// an odd number of cells is one cell wide.
  std::int64_t around[3] = {0, 0, 0};

  /// Lets a direction come round after so many list cells; 0: it does not.
  void set_period(int k, std::int64_t cells) {
    period[k] = (cells + 1) / 2;
    around[k] = 1 + cells % 2;
  }
  [[nodiscard]] HOST_DEVICE Index count() const { return static_cast<Index>(extent[0] * extent[1] * extent[2]); }
};

/// The particles of a list cell: a range of the fluid and one of the walls.
struct DriftCell {
  Index begin[2];
  Index end[2];
};

}  // namespace thalweg
