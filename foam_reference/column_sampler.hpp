#pragma once

#include "common/profile.hpp"
#include "foam_reference/mesh_plan.hpp"

namespace thalweg::foam {

/// Shares of each phase [-] in the cells at one time; `sediment` is empty without sediment.
struct PhaseFields {
  std::vector<double> sediment;
  std::vector<double> air;
};

/// A profile and its uncertainty.
struct SampledProfile {
  Profile profile;
  double largest_free_surface_spread = 0;  // [m] between the column integral and the crossing of 0.5
  double largest_bed_spread = 0;           // [m]
};

/// The eroding bed's columns of cells, in any order of y.
struct BedColumns {
  std::vector<double> x;          // [m]
  std::vector<double> level;      // [m] of the packed bed
  std::vector<double> suspended;  // [m] thickness of the grains in suspension above, packed alike
};

/// Adds the eroding bed to a profile of the same columns: moving_bed is the packed bed, and bed lies above it by the
/// grains in suspension. A dry bed is the free surface too. In 3-D means over y; missing where there is no column.
void add_bed(Profile& profile, const BedColumns& bed);

/// Turns cells into elevations along x [m], one for each column of cells:
///   bed          = z_0 + sum alpha_sediment dz
///   free surface = z_0 + sum (1 - alpha_air) dz,   z_0 lowest point of the column
/// The integral keeps volumes exact and sees films thinner than a cell. Grains in suspension count as bed, and bubbles
/// lower the surface. Where a solid interrupts the column the integral has no meaning; the highest crossing of a share
/// of 0.5 takes its place. In 3-D the profile is the mean over y. `moving_bed` stays empty: a phase has no deposit.
class ColumnSampler {
 public:
  /// `centres`: the cells' centres [m]; fewer than the plan's where solids have been taken out.
  ColumnSampler(const MeshPlan& plan, const std::vector<Vec3>& centres);

  /// The profile of these fields.
  [[nodiscard]] SampledProfile sample(const PhaseFields& fields) const;

 private:
  struct Elevations;
  struct Column;
  [[nodiscard]] Elevations measure(const Column& column, const std::vector<double>& shares) const;

  MeshPlan plan_;
  std::vector<std::int64_t> cell_at_;  // mesh cell at block position i + nx (j + ny k); -1: solid
};

}  // namespace thalweg::foam
