#include "postproc/level_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace thalweg {
namespace {

// Index of the node below a coordinate, and the share of the way to the next node.
struct Place {
  long index;
  double share;
};
Place place_of(double coordinate, double step, long first) {
  const double nodes = coordinate / step - static_cast<double>(first);
  const double below = std::floor(nodes);
  return {static_cast<long>(below), nodes - below};
}

// The corners of a cell of columns: four in 3-D, two in 2-D.
std::vector<std::size_t> corners_of(const SamplingGrid& grid, std::size_t i, std::size_t j) {
  if (grid.ny == 1) return {grid.column(i, 0), grid.column(i + 1, 0)};
  return {grid.column(i, j), grid.column(i + 1, j), grid.column(i, j + 1), grid.column(i + 1, j + 1)};
}

class Balance {
 public:
  Balance(const LevelMap& before, const LevelMap& after)
      : after_(after), change_(after.levels.size(), std::numeric_limits<double>::quiet_NaN()) {
    const SamplingGrid& grid = after.grid;
    for (std::size_t i = 0; i < grid.nx; ++i) {
      for (std::size_t j = 0; j < grid.ny; ++j) {
        const ColumnLevels* then = before.find(grid, i, j);
        if (then == nullptr) continue;
        const std::size_t column = grid.column(i, j);
        change_[column] = after.levels[column].bed - then->bed;
        take_extremes(change_[column], {grid.x(i), grid.y(j), 0});
      }
    }
  }

  std::optional<BedBalance> take() {
    if (!any_) return std::nullopt;
    const SamplingGrid& grid = after_.grid;
    for (std::size_t i = 0; i + 1 < grid.nx; ++i) {
      for (std::size_t j = 0; j + (grid.ny > 1 ? 1 : 0) < grid.ny; ++j) add_cell(corners_of(grid, i, j));
    }
    return result_;
  }

 private:
  void take_extremes(double change, const Vec3& at) {
    if (std::isnan(change)) return;
    if (!any_) result_.scour_at = result_.deposition_at = at;
    any_ = true;
    if (-change > result_.scour) {
      result_.scour = -change;
      result_.scour_at = at;
    }
    if (change > result_.deposition) {
      result_.deposition = change;
      result_.deposition_at = at;
    }
  }

  void add_cell(const std::vector<std::size_t>& corners) {
    const double step = after_.grid.step;
    const double share = (after_.grid.ny == 1 ? step : step * step) / static_cast<double>(corners.size());
    double fell = 0;
    double rose = 0;
    double thickness = 0;
    for (const std::size_t column : corners) {
      fell += std::max(0.0, -change_[column]) + (change_[column] - change_[column]);  // NaN stays NaN
      rose += std::max(0.0, change_[column]);
      thickness += after_.levels[column].bed - after_.levels[column].floor;
    }
    if (!std::isnan(fell)) {
      result_.eroded += share * fell;
      result_.deposited += share * rose;
    }
    if (!std::isnan(thickness)) result_.sediment_volume += share * thickness;
  }

  const LevelMap& after_;
  std::vector<double> change_;
  BedBalance result_;
  bool any_ = false;
};

}  // namespace

double LevelMap::at(double ColumnLevels::*height, double x, double y) const {
  const Place px = place_of(x, grid.step, grid.first_x);
  const Place py = grid.ny == 1 ? Place{0, 0} : place_of(y, grid.step, grid.first_y);
  double sum = 0;
  double weight = 0;
  for (const auto& [di, dj] : {std::array{0L, 0L}, {1L, 0L}, {0L, 1L}, {1L, 1L}}) {
    const long i = px.index + di;
    const long j = py.index + dj;
    if (i < 0 || j < 0 || i >= static_cast<long>(grid.nx) || j >= static_cast<long>(grid.ny)) continue;
    const double share = (di == 1 ? px.share : 1 - px.share) * (dj == 1 ? py.share : 1 - py.share);
    const double value = levels[grid.column(static_cast<std::size_t>(i), static_cast<std::size_t>(j))].*height;
    if (std::isnan(value)) continue;
    sum += share * value;
    weight += share;
  }
  return weight >= 0.5 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

const ColumnLevels* LevelMap::find(const SamplingGrid& like, std::size_t i, std::size_t j) const {
  const long a = static_cast<long>(i) + like.first_x - grid.first_x;
  const long b = grid.ny == 1 ? 0 : static_cast<long>(j) + like.first_y - grid.first_y;
  if (a < 0 || b < 0 || a >= static_cast<long>(grid.nx) || b >= static_cast<long>(grid.ny)) return nullptr;
  return &levels[grid.column(static_cast<std::size_t>(a), static_cast<std::size_t>(b))];
}

std::optional<BedBalance> bed_balance(const LevelMap& before, const LevelMap& after) {
  return Balance(before, after).take();
}

}  // namespace thalweg
