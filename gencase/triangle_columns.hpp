#pragma once

#include <array>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The triangles of a closed surface, sorted into bins across one axis, for lines parallel to it. Exact predicates
/// decide if a line meets a triangle, and a line through an edge or corner meets exactly one of the triangles beside
/// it, so that every line enters a closed surface as often as it leaves it.
class TriangleColumns {
 public:
  /// `surface` must outlive this.
  TriangleColumns(const Triangles& surface, int axis);

  /// The parts of the line inside the surface (winding number above zero).
  [[nodiscard]] Spans inside(const Vec3& on_line) const;

 private:
  using Place = std::array<double, 2>;  // across the axis

  [[nodiscard]] Place across(const Vec3& p) const { return {p[first_], p[second_]}; }
  [[nodiscard]] std::array<int, 2> bin_of(const Place& place) const;
  [[nodiscard]] std::size_t flat(int i, int j) const { return static_cast<std::size_t>(i) * bins_[1] + j; }

  const Triangles& surface_;
  int axis_, first_, second_;
  Place low_{}, bin_size_{};
  std::array<int, 2> bins_{1, 1};
  std::vector<std::uint32_t> first_of_bin_;  // per bin, and one more
  std::vector<std::uint32_t> triangles_;
};

}  // namespace thalweg::gencase
