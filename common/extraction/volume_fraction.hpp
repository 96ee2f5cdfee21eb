#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "common/extraction/classified_particles.hpp"
#include "common/extraction/sampling_grid.hpp"

namespace thalweg {

/// Kernel sums of volume, phi(x) = sum_b V_b W(|x - x_b|, h) [-], with the solver's kernel, at the nodes of a grid.
/// A wall counts as `floor` at nodes above the top of its run, or up to a spacing below it, so that the face itself can
/// be found; further down it counts as `side`. A floor is full where the fluid ends on it, so that a film keeps its
/// thickness. A side wall (or a lid) is taken out of the kernel's reach, so that it does not bend the surface.
struct VolumeFractions {
  explicit VolumeFractions(const SamplingGrid& nodes);

  SamplingGrid grid;
  std::vector<float> fluid;  // water and sediment
  std::vector<float> sediment;
  std::vector<float> resting;  // sediment at rest
  std::vector<float> floor;
  std::vector<float> side;

  /// Fraction of a phase at a node, corrected for the walls in reach: (phase + floor) / (1 - side).
  [[nodiscard]] double with_walls(const std::vector<float>& phase, std::size_t node) const {
    return (double{phase[node]} + double{floor[node]}) / open_share(node);
  }
  /// The same without any phase: 1/2 on the face of a floor.
  [[nodiscard]] double floor_alone(std::size_t node) const { return double{floor[node]} / open_share(node); }
  /// Share of a node's reach that lies in a wall: 1/2 on a wall's face, 1 inside.
  [[nodiscard]] double wall_share(std::size_t node) const { return std::max(double{side[node]}, floor_alone(node)); }
  /// True inside a wall. A node on a wall's face has half of its reach in the wall and still counts as open, also where
  /// floor and side wall meet.
  [[nodiscard]] bool in_wall(std::size_t node) const { return wall_share(node) > most_open_share; }

  static constexpr double most_open_share = 0.55;

 private:
  [[nodiscard]] double open_share(std::size_t node) const {
    constexpr double least = 0.25;  // reached only inside walls, where nothing is evaluated
    return std::max(1 - double{side[node]}, least);
  }
};

/// Adds the particles named by `which` at the nodes with first_column <= i < last_column along x. Ranges of columns
/// share no node, so that several threads may fill one grid at the same time.
void add_volume_fractions(VolumeFractions& sums, const ClassifiedParticles& set, std::span<const std::size_t> which,
                          std::size_t first_column, std::size_t last_column);

/// The sums of all particles over a whole grid, in the order of the particles.
VolumeFractions sum_volume_fractions(const ClassifiedParticles& set, const SamplingGrid& grid);

}  // namespace thalweg
