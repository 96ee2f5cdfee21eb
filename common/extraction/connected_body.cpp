#include "common/extraction/connected_body.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace thalweg {
namespace {

// The height at which a value falls through 1/2 between two heights.
double crossing(double z_full, double full, double z_less, double less) {
  return z_full + (z_less - z_full) * (full - 0.5) / (full - less);
}

}  // namespace

ConnectedBody::ConnectedBody(const VolumeFractions& sums, const std::vector<float>& phase, double gap, double reach)
    : sums_(sums), phase_(phase), belongs_(sums.grid.size(), 0) {
  const SamplingGrid& grid = sums.grid;
  bool any_wall = false;
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < grid.columns(); ++i) {
    for (std::size_t k = 0; k < grid.nz; ++k) {
      const std::size_t node = grid.node(i, k);
      any_wall = any_wall || sums_.in_wall(node);
      if (!belongs(node) && stands_on_wall(i, k) && is_filled(node)) spread_from(node, members);
    }
  }
  if (!any_wall) keep_largest();
  if (gap > 0) join_what_lies_over(gap, reach);
}

bool ConnectedBody::stands_on_wall(std::size_t column, std::size_t row) const {
  return row > 0 && sums_.in_wall(sums_.grid.node(column, row - 1));
}

// Adds all filled nodes connected to `node`; returns how many, and leaves them in `members`.
std::size_t ConnectedBody::spread_from(std::size_t node, std::vector<std::size_t>& members) {
  const SamplingGrid& grid = sums_.grid;
  members.assign(1, node);
  belongs_[node] = 1;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const std::size_t column = members[next] / grid.nz;
    const std::size_t row = members[next] % grid.nz;
    const std::size_t j = column % grid.ny;
    const std::size_t along_x = grid.ny * grid.nz;
    const std::array<std::size_t, 6> neighbours{column >= grid.ny ? members[next] - along_x : none,
                                                column + grid.ny < grid.columns() ? members[next] + along_x : none,
                                                j > 0 ? members[next] - grid.nz : none,
                                                j + 1 < grid.ny ? members[next] + grid.nz : none,
                                                row > 0 ? members[next] - 1 : none,
                                                row + 1 < grid.nz ? members[next] + 1 : none};
    for (const std::size_t neighbour : neighbours) {
      if (neighbour == none || belongs(neighbour) || !is_filled(neighbour)) continue;
      belongs_[neighbour] = 1;
      members.push_back(neighbour);
    }
  }
  return members.size();
}

void ConnectedBody::keep_largest() {
  std::vector<std::size_t> members;
  std::vector<std::size_t> largest;
  for (std::size_t node = 0; node < belongs_.size(); ++node) {
    if (belongs(node) || !is_filled(node)) continue;
    if (spread_from(node, members) > largest.size()) largest.swap(members);
  }
  std::fill(belongs_.begin(), belongs_.end(), 0);
  for (const std::size_t node : largest) belongs_[node] = 1;
}

void ConnectedBody::join_what_lies_over(double gap, double reach) {
  const std::vector<char> standing = belongs_;  // what is joined carries nothing: a stack of sheets is spray
  std::vector<std::size_t> members;
  std::vector<std::size_t> joined;
  for (std::size_t node = 0; node < belongs_.size(); ++node) {
    if (!is_apart(node)) continue;
    spread_from(node, members);
    if (lies_over(members, standing, gap, reach)) joined.insert(joined.end(), members.begin(), members.end());
  }
  belongs_ = standing;
  for (const std::size_t node : joined) belongs_[node] = 1;
}

// True for a body as wide as `reach` with no more than `gap` between it and the standing one, under half of its columns.
bool ConnectedBody::lies_over(const std::vector<std::size_t>& members, const std::vector<char>& standing, double gap,
                              double reach) const {
  const SamplingGrid& grid = sums_.grid;
  const auto rows = static_cast<std::size_t>(gap / grid.step);
  std::map<std::size_t, std::size_t> lowest;  // row of each column
  for (const std::size_t node : members) {
    const auto [at, is_new] = lowest.try_emplace(node / grid.nz, node % grid.nz);
    if (!is_new) at->second = std::min(at->second, node % grid.nz);
  }
  std::size_t carried = 0;
  for (const auto& [column, row] : lowest) {
    const std::size_t from = row - std::min(row, rows + 1);
    for (std::size_t k = from; k < row; ++k) {
      const std::size_t node = grid.node(column, k);
      if (standing[node] == 0 && !sums_.in_wall(node)) continue;
      ++carried;
      break;
    }
  }
  const std::size_t first = lowest.begin()->first / grid.ny;
  const std::size_t last = lowest.rbegin()->first / grid.ny;
  return static_cast<double>(last - first) * grid.step >= reach && 2 * carried >= lowest.size();
}

std::size_t ConnectedBody::highest_row(std::size_t column) const {
  for (std::size_t k = sums_.grid.nz; k-- > 0;) {
    if (belongs(sums_.grid.node(column, k))) return k;
  }
  return none;
}

double ConnectedBody::top(std::size_t column) const {
  const SamplingGrid& grid = sums_.grid;
  const std::size_t k = highest_row(column);
  if (k == none) return absent;
  const std::size_t above = grid.node(column, k + 1);
  if (k + 1 == grid.nz || sums_.in_wall(above)) return grid.z(k);  // it reaches the grid's edge or a lid
  return crossing(grid.z(k), fraction(grid.node(column, k)), grid.z(k + 1), fraction(above));
}

double ConnectedBody::top_below_walls(std::size_t column) const {
  const SamplingGrid& grid = sums_.grid;
  const auto in_wall = [&](std::size_t k) { return sums_.in_wall(grid.node(column, k)); };
  std::size_t k = 0;
  while (k + 1 < grid.nz && (in_wall(k) || !belongs(grid.node(column, k)))) ++k;
  while (k + 1 < grid.nz && belongs(grid.node(column, k + 1))) ++k;
  const bool hangs_above = [&] {
    for (std::size_t above = k + 2; above < grid.nz; ++above) {
      if (in_wall(above)) return true;
    }
    return false;
  }();
  if (!belongs(grid.node(column, k)) || !hangs_above || in_wall(k + 1)) return absent;
  return crossing(grid.z(k), fraction(grid.node(column, k)), grid.z(k + 1), fraction(grid.node(column, k + 1)));
}

double ConnectedBody::base(std::size_t column) const {
  const SamplingGrid& grid = sums_.grid;
  std::size_t k = highest_row(column);
  if (k == none) return absent;
  std::size_t lowest_of_body = k;
  while (k > 0 && !sums_.in_wall(grid.node(column, k))) {
    if (belongs(grid.node(column, k))) lowest_of_body = k;
    --k;
  }
  if (!sums_.in_wall(grid.node(column, k))) {
    k = lowest_of_body;
    if (k == 0) return grid.z(0);
    return crossing(grid.z(k), fraction(grid.node(column, k)), grid.z(k - 1), fraction(grid.node(column, k - 1)));
  }
  const auto wall_fraction = [&](std::size_t row) { return sums_.floor_alone(grid.node(column, row)); };
  while (k + 1 < grid.nz && wall_fraction(k + 1) >= 0.5) ++k;
  if (k + 1 == grid.nz || wall_fraction(k) < 0.5) return grid.z(k);
  return crossing(grid.z(k), wall_fraction(k), grid.z(k + 1), wall_fraction(k + 1));
}

}  // namespace thalweg
