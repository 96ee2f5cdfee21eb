#pragma once

#include <limits>
#include <vector>

#include "common/extraction/volume_fraction.hpp"

namespace thalweg {

/// Stands for a height that is not there [m].
inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// The nodes where a phase fills more than half and that are connected to the floor along the axes without crossing
/// a wall. Without any wall on the grid: the nodes of the largest connected body. A body apart is part of it if it lies
/// over it as a wave lies on its floor: at least `reach` wide along x, and over at least half of its columns no more
/// than `gap` of air below. A drop is narrower.
class ConnectedBody {
 public:
  /// gap [m]: largest height of air that is bridged, 0: none; reach [m].
  ConnectedBody(const VolumeFractions& sums, const std::vector<float>& phase, double gap = 0, double reach = 0);

  /// Highest crossing of 1/2 of the body in a column [m]; NaN where it has no node there.
  [[nodiscard]] double top(std::size_t column) const;
  /// The lowest crossing of the body below a wall that hangs in a column, a pipe or a slab; NaN without such a wall, and
  /// where it lies on the body.
  [[nodiscard]] double top_below_walls(std::size_t column) const;
  /// The wall under the body's top in a column [m]; without a wall the body's own lower edge; NaN without body.
  [[nodiscard]] double base(std::size_t column) const;

  [[nodiscard]] bool belongs(std::size_t node) const { return belongs_[node] != 0; }
  /// A filled node of some other body: a drop, a floating grain.
  [[nodiscard]] bool is_apart(std::size_t node) const { return !belongs(node) && is_filled(node); }
  /// Fraction of the phase with the walls' part settled (VolumeFractions::with_walls).
  [[nodiscard]] double fraction(std::size_t node) const { return sums_.with_walls(phase_, node); }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] bool is_filled(std::size_t node) const { return !sums_.in_wall(node) && fraction(node) >= 0.5; }
  [[nodiscard]] bool stands_on_wall(std::size_t column, std::size_t row) const;
  [[nodiscard]] std::size_t highest_row(std::size_t column) const;
  std::size_t spread_from(std::size_t node, std::vector<std::size_t>& members);
  void keep_largest();
  void join_what_lies_over(double gap, double reach);
  [[nodiscard]] bool lies_over(const std::vector<std::size_t>& members, const std::vector<char>& standing, double gap,
                               double reach) const;

  const VolumeFractions& sums_;
  const std::vector<float>& phase_;
  std::vector<char> belongs_;  // of each node: 1 or 0; bytes are quicker to look up than bits
};

}  // namespace thalweg
