#pragma once

#include <functional>
#include <vector>

// The packed bed of the eroding-bed model as columns of grains. No OpenFOAM here, so that it can be read and tested
// alone; every rank of a parallel run holds the whole bed and changes it alike.
namespace thalweg::foam {

/// Columns beside each other, x fastest.
struct BedGrid {
  int nx = 1;
  int ny = 1;
  double dx = 1;  // [m]
  double dy = 1;  // [m]
  bool periodic_x = false;
  bool periodic_y = false;

  [[nodiscard]] int columns() const { return nx * ny; }
  /// The column one step along x (axis 0) or y (axis 1), forward or back; -1 beyond the end.
  [[nodiscard]] int neighbour(int column, int axis, bool forward) const;
  [[nodiscard]] double spacing(int axis) const { return axis == 0 ? dx : dy; }
};

/// Grains at rest. A column without area is solid and holds nothing.
struct Bed {
  BedGrid grid;
  double packing = 1;          // [-] share of the bed's volume that is grains
  std::vector<double> area;    // [m^2]
  std::vector<double> floor;   // [m] what the bed lies on
  std::vector<double> grains;  // [m^3] volume of grains in each column

  /// Elevation of the bed's surface [m].
  [[nodiscard]] double level(int column) const;
  /// Whether the next column is there and holds or could hold a bed.
  [[nodiscard]] int open_neighbour(int column, int axis, bool forward) const;
  /// Slope of the surface [-] along an axis: central differences, one-sided beside walls.
  [[nodiscard]] double slope(int column, int axis) const;
  /// Slope [-] towards an open neighbour, upwards positive along the axis.
  [[nodiscard]] double slope_between(int column, int axis, bool forward) const;
  /// Sum of all grains [m^3].
  [[nodiscard]] double total() const;
};

/// Bed load [m^2/s], volume of grains per metre of width, that a column sends to its neighbour along an axis, >= 0.
using BedLoadSent = std::function<double(int column, int axis, bool forward)>;

/// Moves grains with the bed load for dt [s]. No column gives more than it has; nothing crosses walls; grains are
/// conserved to rounding.
void move_bed_load(Bed& bed, const BedLoadSent& sent, double dt);

/// Lets columns slide that are steeper than tan(angle of repose): pair by pair the excess moves down, until none is
/// left or the sweeps are used up (the rest slides in the next step). Grains are conserved to rounding. Returns whether
/// all slopes are at rest.
bool avalanche(Bed& bed, double tan_repose, int most_sweeps = 50);

}  // namespace thalweg::foam
