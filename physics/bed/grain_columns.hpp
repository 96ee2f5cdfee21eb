#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

// A packed bed as columns of grains: the bed of model.sediment = "surface" under particles, and of the eroding-bed model
// in OpenFOAM. Both move it by the same functions, so that equal stresses give equal beds, bit for bit.
namespace thalweg {

/// Columns beside each other; their numbers grow along x first.
struct BedGrid {
  int nx = 1;
  int ny = 1;
  double dx = 1;  // [m] width of a column along x
  double dy = 1;  // [m] along y
  bool periodic_x = false;
  bool periodic_y = false;

  [[nodiscard]] int columns() const { return nx * ny; }
  [[nodiscard]] double spacing(int axis) const { return axis == 0 ? dx : dy; }
  /// The column one step forward or back along x (axis 0) or y (axis 1); -1 beyond the end.
  [[nodiscard]] int neighbour(int column, int axis, bool forward) const {
    int at[2] = {column % nx, column / nx};
    const int count = axis == 0 ? nx : ny;
    at[axis] += forward ? 1 : -1;
    if (at[axis] < 0 || at[axis] >= count) {
      if (!(axis == 0 ? periodic_x : periodic_y) || count == 1) return -1;
      at[axis] = (at[axis] + count) % count;
    }
    return at[1] * nx + at[0];
  }
};

/// The end of the bed beside a column.
///   closed       nothing crosses it
///   fed          grains come in at the rate at which the column sends them on, so that it keeps its level
///   back_x …     grains leave backwards or forwards along an axis at the rate at which the column sends them
enum class BedEnd : std::uint8_t { closed, fed, back_x, forth_x, back_y, forth_y };

/// The open end that lies along an axis.
constexpr BedEnd open_end(int axis, bool forward) {
  return axis == 0 ? (forward ? BedEnd::forth_x : BedEnd::back_x) : (forward ? BedEnd::forth_y : BedEnd::back_y);
}

/// Grains at rest. A column without area is solid and holds nothing.
struct GrainColumns {
  BedGrid grid;
  double packing = 1;           // [-] share of the bed's volume that is grains
  std::vector<double> area;     // [m^2]
  std::vector<double> floor;    // [m] elevation of the ground under the bed
  std::vector<double> grains;   // [m^3] volume of grains in each column
  std::vector<double> ceiling;  // [m] elevation of what hangs over each column; empty: nothing anywhere
  std::vector<BedEnd> end;      // of each column; empty: all closed
  double fed = 0;               // [m^3] volume of grains that came in at the ends
  double left = 0;              // [m^3] and that went out
  double lifted = 0;            // [m^3] and that the water took, less those that settled

  /// Elevation of the bed's surface [m].
  [[nodiscard]] double level(int column) const {
    const double bulk = packing * area[at(column)];
    return floor[at(column)] + (bulk > 0 ? grains[at(column)] / bulk : 0);
  }
  /// The next column, if it exists and is not solid; else -1.
  [[nodiscard]] int open_neighbour(int column, int axis, bool forward) const {
    const int next = grid.neighbour(column, axis, forward);
    return next >= 0 && area[at(next)] > 0 ? next : -1;
  }
  /// Slope of the surface [-] along an axis: central differences, one-sided beside walls.
  [[nodiscard]] double slope(int column, int axis) const {
    const int behind = open_neighbour(column, axis, false);
    const int ahead = open_neighbour(column, axis, true);
    const int steps = (behind >= 0 ? 1 : 0) + (ahead >= 0 ? 1 : 0);
    if (steps == 0) return 0;
    return (level(ahead >= 0 ? ahead : column) - level(behind >= 0 ? behind : column)) / (steps * grid.spacing(axis));
  }
  /// Slope [-] between the column and its open neighbour, positive where the surface rises along the axis.
  [[nodiscard]] double slope_between(int column, int axis, bool forward) const {
    const int next = open_neighbour(column, axis, forward);
    return (level(next) - level(column)) / ((forward ? 1 : -1) * grid.spacing(axis));
  }
  /// Volume of grains [m^3] that a column has room for.
  [[nodiscard]] double room(int column) const {
    if (ceiling.empty()) return std::numeric_limits<double>::infinity();
    const double most = (ceiling[at(column)] - floor[at(column)]) * packing * area[at(column)] - grains[at(column)];
    return most > 0 ? most : 0;
  }
  [[nodiscard]] BedEnd end_at(int column) const { return end.empty() ? BedEnd::closed : end[at(column)]; }
  /// Sum of all grains [m^3].
  [[nodiscard]] double total() const { return std::accumulate(grains.begin(), grains.end(), 0.0); }

  static std::size_t at(int column) { return static_cast<std::size_t>(column); }
};

}  // namespace thalweg
