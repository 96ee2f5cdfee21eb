#pragma once

#include <cstddef>

#include "common/particles.hpp"

namespace thalweg {

/// The nodes of a regular grid in space, or in a plane x-z at one y. Nodes lie at multiples of `step`, so that grids of
/// different times share their nodes.
struct SamplingGrid {
  double step = 0;   // [m]
  long first_x = 0;  // [-] x of node (0, ·, ·) over step
  long first_y = 0;  // [-]
  long first_z = 0;  // [-]
  std::size_t nx = 0;
  std::size_t ny = 1;  // 1: a plane
  std::size_t nz = 0;
  double plane_y = 0;  // [m] of a plane; without meaning in 2-D

  [[nodiscard]] bool is_plane() const { return ny == 1; }
  [[nodiscard]] double x(std::size_t i) const { return static_cast<double>(first_x + static_cast<long>(i)) * step; }
  [[nodiscard]] double y(std::size_t j) const {
    return is_plane() ? plane_y : static_cast<double>(first_y + static_cast<long>(j)) * step;
  }
  [[nodiscard]] double z(std::size_t k) const { return static_cast<double>(first_z + static_cast<long>(k)) * step; }
  /// Number of columns of nodes. Their index grows with y first, then with x.
  [[nodiscard]] std::size_t columns() const { return nx * ny; }
  [[nodiscard]] std::size_t column(std::size_t i, std::size_t j) const { return i * ny + j; }
  [[nodiscard]] std::size_t node(std::size_t column, std::size_t k) const { return column * nz + k; }
  [[nodiscard]] std::size_t size() const { return columns() * nz; }
};

/// The smallest grid of that `step` over a rectangle in the plane at `y` [m].
SamplingGrid make_slice_grid(double step, double x_from, double x_to, double z_from, double z_to, double y);
/// The smallest grid of that `step` over a box [m].
SamplingGrid make_volume_grid(double step, const Vec3& from, const Vec3& to);

}  // namespace thalweg
