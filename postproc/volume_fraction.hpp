#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "common/particles.hpp"
#include "postproc/wall_runs.hpp"

namespace thalweg {

[[nodiscard]] inline bool is_wall(ParticleType type) {
  return type == ParticleType::wall || type == ParticleType::moving_wall;
}
[[nodiscard]] inline bool is_fluid(ParticleType type) { return !is_wall(type); }

/// Nodes of a regular grid in the plane x-z at one y. Node (i, k) lies at multiples of `step`, so that grids of
/// different times share their nodes.
struct SliceGrid {
  double step = 0;   // [m]
  long first_x = 0;  // [-] x of node (0, ·) over step
  long first_z = 0;  // [-]
  std::size_t nx = 0;
  std::size_t nz = 0;
  double y = 0;  // [m] the plane; without meaning in 2-D

  [[nodiscard]] double x(std::size_t i) const { return static_cast<double>(first_x + static_cast<long>(i)) * step; }
  [[nodiscard]] double z(std::size_t k) const { return static_cast<double>(first_z + static_cast<long>(k)) * step; }
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t k) const { return i * nz + k; }
  [[nodiscard]] std::size_t size() const { return nx * nz; }
};

/// The smallest grid of that `step` over a rectangle [m].
SliceGrid make_slice_grid(double step, double x_from, double x_to, double z_from, double z_to, double y);

/// Wendland's C2 kernel, W = sigma (1 - q/2)^4 (2 q + 1), q = r/h <= 2; sigma = 7/(4 pi h^2) in 2-D, 21/(16 pi h^3) in
/// 3-D (Wendland 1995; the solver's kernel, docs/theory.md).
struct WendlandC2 {
  WendlandC2(double smoothing_length, int dimension);
  [[nodiscard]] double operator()(double distance_squared) const;
  [[nodiscard]] double support() const { return 2 * h; }

  double h;      // [m]
  double sigma;  // [1/m^2] or [1/m^3]
};

/// Kernel sums of volume, phi(x) = sum_b V_b W(|x - x_b|, h) [-], at the nodes of a grid. Walls count as `floor` at
/// nodes above their run's top (or less than a spacing below it, so that the face itself can be found) and as `side`
/// further down: a floor is full where the fluid ends on it, so that a film keeps its thickness; a side wall (or a lid)
/// is taken out of the sum's reach, so that it does not bend the surface.
struct VolumeFractions {
  SliceGrid grid;
  std::vector<double> fluid;  // water and sediment
  std::vector<double> sediment;
  std::vector<double> resting;  // sediment at rest
  std::vector<double> floor;
  std::vector<double> side;

  /// Fraction of a phase at a node with the walls' part settled: (phase + floor) / (1 - side).
  [[nodiscard]] double with_walls(const std::vector<double>& phase, std::size_t node) const;
  /// The same without any phase: 1/2 on the face of a floor.
  [[nodiscard]] double floor_alone(std::size_t node) const { return floor[node] / open_share(node); }
  /// Whether a node lies inside a wall. A node on a wall's face has half of its reach in it and is still open, also
  /// where floor and side wall meet.
  [[nodiscard]] bool in_wall(std::size_t node) const { return side[node] > 0.55 || floor_alone(node) > 0.55; }

 private:
  [[nodiscard]] double open_share(std::size_t node) const;
};

/// Fills the sums; `at_rest(i)` says which sediment particles rest.
VolumeFractions sum_volume_fractions(const ParticleSet& particles, const WallRuns& walls, const SliceGrid& grid,
                                     const std::function<bool(std::size_t)>& at_rest);

}  // namespace thalweg
