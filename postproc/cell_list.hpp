#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// Particles sorted into cubes of one edge length, x slowest, so that a slab in x is one run of particles.
class CellList {
 public:
  CellList(const std::vector<Vec3>& positions, double edge);

  /// All particles whose cube touches from <= x <= to [m].
  [[nodiscard]] std::span<const std::size_t> slab(double from, double to) const;

  /// Calls `visit(i)` for every particle within an edge of `at`, and for others nearby.
  template <class Visit>
  void around(const Vec3& at, Visit&& visit) const {
    const std::array<long, 3> cell = cell_of(at);
    for (long a = std::max(0L, cell[0] - 1); a < std::min(count_[0], cell[0] + 2); ++a) {
      for (long b = std::max(0L, cell[1] - 1); b < std::min(count_[1], cell[1] + 2); ++b) {
        const long c = std::clamp(cell[2] - 1, 0L, count_[2]);
        const long d = std::clamp(cell[2] + 2, 0L, count_[2]);
        for (std::size_t n = begin_[index(a, b, c)]; n < begin_[index(a, b, d)]; ++n) visit(order_[n]);
      }
    }
  }

 private:
  [[nodiscard]] std::array<long, 3> cell_of(const Vec3& at) const;
  [[nodiscard]] std::size_t index(long a, long b, long c) const {
    return static_cast<std::size_t>((a * count_[1] + b) * count_[2] + c);
  }

  Vec3 low_ = Vec3::Zero();
  double edge_;
  std::array<long, 3> count_{0, 0, 0};
  std::vector<std::size_t> begin_;  // of each cell, and the end
  std::vector<std::size_t> order_;
};

}  // namespace thalweg
