#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "gencase/shapes.hpp"

namespace thalweg::gencase {

using Index3 = std::array<std::int64_t, 3>;

/// The points anchor + (i + 1/2) spacing at which particles of a scene may stand, arranged in columns along gravity. In
/// 2-D the y index has one value and y is 0.
struct Lattice {
  Vec3 anchor = Vec3::Zero();  // [m]
  double spacing = 0;          // [m]
  int dimension = 2;
  Index3 first{};                    // lowest index in each direction
  Index3 count{};                    // nodes in each direction
  std::array<int, 3> axes{0, 1, 2};  // from the slowest to the fastest; the last one runs along the columns

  [[nodiscard]] std::int64_t nodes() const { return count[0] * count[1] * count[2]; }
  [[nodiscard]] std::int64_t column_length() const { return count[axes[2]]; }
  [[nodiscard]] std::int64_t columns() const { return nodes() / column_length(); }
  /// Volume [m^3] (2-D: area [m^2]) of one node.
  [[nodiscard]] double cell() const { return dimension == 2 ? spacing * spacing : spacing * spacing * spacing; }

  [[nodiscard]] Vec3 position(const Index3& offset) const;  // [m]; offset counts from `first`
  [[nodiscard]] std::int64_t flat(const Index3& offset) const {
    return (offset[axes[0]] * count[axes[1]] + offset[axes[1]]) * count[axes[2]] + offset[axes[2]];
  }
  [[nodiscard]] Index3 offset(std::int64_t flat_index) const;
};

/// Columns whose indices lie within `bounds`.
struct ColumnRange {
  Index3 begin{};
  Index3 end{};
  [[nodiscard]] std::int64_t columns(const Lattice& lattice) const {
    return (end[lattice.axes[0]] - begin[lattice.axes[0]]) * (end[lattice.axes[1]] - begin[lattice.axes[1]]);
  }
};

/// The columns that pass within a spacing of `bounds`.
ColumnRange columns_within(const Lattice& lattice, const Bounds& bounds);

/// The line through the nodes of a column, moved by `nudge` [m].
Line line_of(const Lattice& lattice, std::int64_t column, const Vec3& nudge);

/// The lattice over all of `shapes`, anchored as the case says; by default at the lower corner of the first container,
/// so that the first particles stand half a spacing from flat walls. `spacing` [m] may differ from the case's, for
/// estimates. Throws InputError if the shapes stretch over too many spacings.
Lattice make_lattice(const Case& scene, const std::vector<PlacedShape>& shapes, double spacing);

/// Throws InputError if the length of the domain in a periodic direction is not a whole number of spacings: the lattice
/// would not continue across the period.
void check_periods(const Case& scene);

/// One line for each box face that lies more than a hundredth of the spacing off the lattice, saying by how much.
std::vector<std::string> faces_off_lattice(const Case& scene, const Lattice& lattice);

}  // namespace thalweg::gencase
