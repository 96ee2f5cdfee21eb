#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/extraction/wall_runs.hpp"
#include "common/particles.hpp"

namespace thalweg {

[[nodiscard]] inline bool is_wall(ParticleType type) {
  return type == ParticleType::wall || type == ParticleType::moving_wall;
}
[[nodiscard]] inline bool is_fluid(ParticleType type) { return !is_wall(type); }

/// Nodes of a regular grid: in space, or in the plane x-z at one y. Node (i, j, k) lies at multiples of `step`, so that
/// grids of different times share their nodes.
struct SamplingGrid {
  double step = 0;   // [m]
  long first_x = 0;  // [-] x of node (0, ·, ·) over step
  long first_y = 0;  // [-]
  long first_z = 0;  // [-]
  std::size_t nx = 0;
  std::size_t ny = 1;  // 1: a plane
  std::size_t nz = 0;
  double plane_y = 0;  // [m] of a plane; without meaning in 2-D

  [[nodiscard]] double x(std::size_t i) const { return static_cast<double>(first_x + static_cast<long>(i)) * step; }
  [[nodiscard]] double y(std::size_t j) const {
    return ny == 1 ? plane_y : static_cast<double>(first_y + static_cast<long>(j)) * step;
  }
  [[nodiscard]] double z(std::size_t k) const { return static_cast<double>(first_z + static_cast<long>(k)) * step; }
  /// Columns of nodes above each other, y running faster than x.
  [[nodiscard]] std::size_t columns() const { return nx * ny; }
  [[nodiscard]] std::size_t column(std::size_t i, std::size_t j) const { return i * ny + j; }
  [[nodiscard]] std::size_t node(std::size_t column, std::size_t k) const { return column * nz + k; }
  [[nodiscard]] std::size_t size() const { return columns() * nz; }
};

/// The smallest grid of that `step` over a rectangle in the plane at `y` [m].
SamplingGrid make_slice_grid(double step, double x_from, double x_to, double z_from, double z_to, double y);
/// The smallest grid of that `step` over a box [m].
SamplingGrid make_volume_grid(double step, const Vec3& from, const Vec3& to);

/// What a particle counts as.
enum class Part : std::uint8_t { water, moving_sediment, resting_sediment, wall };

/// The parts of all particles. Sediment rests where it is slower than `rest_speed` [m/s] and, in a set with states, a
/// deposit; without states and velocities none does.
std::vector<Part> parts_of(const ParticleSet& particles, double rest_speed);

/// Whether a set's State says which sediment rests (some sediment particle has a state).
bool has_sediment_states(const ParticleSet& particles);

/// Kernel sums of volume, phi(x) = sum_b V_b W(|x - x_b|, h) [-], with the solver's kernel, at the nodes of a grid.
/// Walls count as `floor` at nodes above their run's top (or up to a spacing below it, so that the face itself can
/// be found) and as `side` further down: a floor is full where the fluid ends on it, so that a film keeps its
/// thickness; a side wall (or a lid) is taken out of the sum's reach, so that it does not bend the surface.
struct VolumeFractions {
  explicit VolumeFractions(const SamplingGrid& nodes);

  SamplingGrid grid;
  std::vector<float> fluid;  // water and sediment
  std::vector<float> sediment;
  std::vector<float> resting;  // sediment at rest
  std::vector<float> floor;
  std::vector<float> side;

  /// Fraction of a phase at a node with the walls' part settled: (phase + floor) / (1 - side).
  [[nodiscard]] double with_walls(const std::vector<float>& phase, std::size_t node) const;
  /// The same without any phase: 1/2 on the face of a floor.
  [[nodiscard]] double floor_alone(std::size_t node) const { return double{floor[node]} / open_share(node); }
  /// How much of a wall a node lies in: 1/2 on a wall's face, 1 inside.
  [[nodiscard]] double wall_share(std::size_t node) const;
  /// Whether a node lies inside a wall. A node on a wall's face has half of its reach in it and is still open, also
  /// where floor and side wall meet.
  [[nodiscard]] bool in_wall(std::size_t node) const { return wall_share(node) > most_open_share; }

  static constexpr double most_open_share = 0.55;

 private:
  [[nodiscard]] double open_share(std::size_t node) const;
};

/// Adds the particles named by `which` at the nodes with first_column <= i < last_column along x; parts of a grid that
/// share no node may be filled at the same time. `parts` and `walls` are those of all particles.
void add_volume_fractions(VolumeFractions& sums, const ParticleSet& particles, const std::vector<Part>& parts,
                          const WallRuns& walls, std::span<const std::size_t> which, std::size_t first_column,
                          std::size_t last_column);

/// The sums of all particles over a whole grid.
VolumeFractions sum_volume_fractions(const ParticleSet& particles, const std::vector<Part>& parts,
                                     const WallRuns& walls, const SamplingGrid& grid);

}  // namespace thalweg
