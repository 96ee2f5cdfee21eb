#include "postproc/cell_list.hpp"

#include <cmath>

namespace thalweg {

CellList::CellList(const std::vector<Vec3>& positions, double edge) : edge_(edge), begin_(1, 0) {
  if (positions.empty()) return;
  low_ = positions.front();
  Vec3 high = low_;
  for (const Vec3& at : positions) {
    low_ = low_.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const std::array<long, 3> last = cell_of(high);
  for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = last[axis] + 1;

  begin_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
  const auto cell = [&](const Vec3& at) {
    const std::array<long, 3> c = cell_of(at);
    return index(c[0], c[1], c[2]);
  };
  for (const Vec3& at : positions) ++begin_[cell(at) + 1];
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  order_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) order_[next[cell(positions[i])]++] = i;
}

std::array<long, 3> CellList::cell_of(const Vec3& at) const {
  std::array<long, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    cell[static_cast<std::size_t>(axis)] = static_cast<long>(std::floor((at[axis] - low_[axis]) / edge_));
  }
  return cell;
}

std::span<const std::size_t> CellList::slab(double from, double to) const {
  const auto clip = [&](double x, long more) {
    const long cell = static_cast<long>(std::floor((x - low_.x()) / edge_)) + more;
    return index(std::clamp(cell, 0L, count_[0]), 0, 0);
  };
  const std::size_t first = begin_[clip(from, 0)];
  return {order_.data() + first, begin_[clip(to, 1)] - first};
}

}  // namespace thalweg
