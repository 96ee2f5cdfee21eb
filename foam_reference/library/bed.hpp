#pragma once

#include <functional>
#include <vector>

// The packed bed of the eroding-bed model as columns of grains. This file includes nothing of OpenFOAM, so that it can
// be read and tested alone. Every rank of a parallel run holds the whole bed and changes it alike.
namespace thalweg::foam {

/// Columns beside each other; their numbers grow along x first.
struct BedGrid {
  int nx = 1;
  int ny = 1;
  double dx = 1;  // [m] width of a column along x
  double dy = 1;  // [m] along y
  bool periodic_x = false;
  bool periodic_y = false;

  [[nodiscard]] int columns() const { return nx * ny; }
  /// The column one step forward or back along x (axis 0) or y (axis 1); -1 beyond the end.
  [[nodiscard]] int neighbour(int column, int axis, bool forward) const;
  [[nodiscard]] double spacing(int axis) const { return axis == 0 ? dx : dy; }
};

/// Grains at rest. A column without area is solid and holds nothing.
struct Bed {
  BedGrid grid;
  double packing = 1;          // [-] share of the bed's volume that is grains
  std::vector<double> area;    // [m^2]
  std::vector<double> floor;   // [m] elevation of the ground under the bed
  std::vector<double> grains;  // [m^3] volume of grains in each column

  /// Elevation of the bed's surface [m].
  [[nodiscard]] double level(int column) const;
  /// The next column, if it exists and is not solid; else -1.
  [[nodiscard]] int open_neighbour(int column, int axis, bool forward) const;
  /// Slope of the surface [-] along an axis: central differences, one-sided beside walls.
  [[nodiscard]] double slope(int column, int axis) const;
  /// Slope [-] between the column and its open neighbour, positive where the surface rises along the axis.
  [[nodiscard]] double slope_between(int column, int axis, bool forward) const;
  /// Sum of all grains [m^3].
  [[nodiscard]] double total() const;
};

/// Bed load [m^2/s], volume of grains per metre of width, that a column sends to its neighbour along an axis, >= 0.
using BedLoadSent = std::function<double(int column, int axis, bool forward)>;

/// Moves grains by the bed load for dt [s]. No column gives more than it has, and nothing crosses walls. Grains are
/// conserved to rounding.
void move_bed_load(Bed& bed, const BedLoadSent& sent, double dt);

/// Lets slopes slide that are steeper than tan_repose, the tangent of the angle of repose [-]. Between each two columns
/// the excess moves down, until no slope is too steep or the sweeps are used up; the rest slides in the next step.
/// Grains are conserved to rounding. Returns true if all slopes are at rest.
bool avalanche(Bed& bed, double tan_repose, int most_sweeps = 50);

}  // namespace thalweg::foam
