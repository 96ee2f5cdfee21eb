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

/// Height of a column's bed; its floor where that is bare or dry, and NaN on a wall that moves.
double bed_of(const ColumnLevels& levels, double ColumnLevels::*height) {
  const bool dry = std::isnan(levels.free_surface);
  return dry ? levels.floor : levels.*height;
}

struct Change {
  double before;  // [m] NaN where the two heights cannot be compared
  double now;     // [m]
  bool of_bed;    // sediment lies there before or after

  [[nodiscard]] double rise() const { return now - before; }
};

/// The change of column (i, j) of `after`.
Change change_of(const LevelMap& before, const LevelMap& after, std::size_t i, std::size_t j,
                 double ColumnLevels::*height) {
  const ColumnLevels& now = after.levels[after.grid.column(i, j)];
  const ColumnLevels* found = before.find(after.grid, i, j);
  // No fluid was near a column that the first map does not reach: its floor was bare and dry.
  const double dry = std::numeric_limits<double>::quiet_NaN();
  const ColumnLevels then = found != nullptr ? *found : ColumnLevels{dry, dry, dry, now.floor};
  if (!(std::abs(now.floor - then.floor) <= after.grid.step))
    return {dry, dry, false};  // another wall: a deck, a piston
  if (std::isnan(now.free_surface) && std::isnan(then.free_surface)) return {dry, dry, false};  // perhaps inside a wall
  const double level = bed_of(now, height);
  const double first = bed_of(then, height);
  const double layer = least_layer * after.grid.step;
  return {first, level, level - now.floor > layer || first - then.floor > layer};
}

class Balance {
 public:
  Balance(const LevelMap& before, const LevelMap& after) : after_(after) {
    const SamplingGrid& grid = after.grid;
    change_.assign(after.levels.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < grid.nx; ++i) {
      for (std::size_t j = 0; j < grid.ny; ++j) {
        const std::size_t column = grid.column(i, j);
        const Change bed = change_of(before, after, i, j, &ColumnLevels::bed);
        change_[column] = bed.rise();
        take_extremes(bed, {grid.x(i), grid.y(j), 0});
        take_resting(change_of(before, after, i, j, &ColumnLevels::motionless_bed), {grid.x(i), grid.y(j), 0});
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
  void take_extremes(const Change& change, const Vec3& at) {
    if (std::isnan(change.rise()) || !change.of_bed) return;
    if (!any_) result_.scour_at = result_.deposition_at = at;
    any_ = true;
    if (-change.rise() > result_.scour) {
      result_.scour = -change.rise();
      result_.scour_at = at;
    }
    if (change.rise() > result_.deposition) {
      result_.deposition = change.rise();
      result_.deposition_at = at;
    }
  }

  void take_resting(const Change& change, const Vec3& at) {
    if (std::isnan(change.rise()) || !change.of_bed) return;
    if (std::max(0.0, -change.rise()) <= result_.resting_scour) return;
    result_.resting_scour = std::max(0.0, -change.rise());
    result_.resting_scour_at = at;
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
      thickness += bed_of(after_.levels[column], &ColumnLevels::bed) - after_.levels[column].floor;
    }
    if (!std::isnan(fell)) {
      result_.eroded += share * fell;
      result_.deposited += share * rose;
    }
    if (!std::isnan(thickness)) result_.sediment_volume += share * thickness;
  }

  const LevelMap& after_;
  std::vector<double> change_;  // [m] of each column
  BedBalance result_;
  bool any_ = false;
};

/// A height between columns, linear in x and y; NaN where columns that have it weigh less than asked for.
template <class Height>
double between(const LevelMap& map, double x, double y, const Height& height, double least_weight = 0.5) {
  const SamplingGrid& grid = map.grid;
  const Place px = place_of(x, grid.step, grid.first_x);
  const Place py = grid.ny == 1 ? Place{0, 0} : place_of(y, grid.step, grid.first_y);
  double sum = 0;
  double weight = 0;
  for (const auto& [di, dj] : {std::array{0L, 0L}, {1L, 0L}, {0L, 1L}, {1L, 1L}}) {
    const long i = px.index + di;
    const long j = py.index + dj;
    if (i < 0 || j < 0 || i >= static_cast<long>(grid.nx) || j >= static_cast<long>(grid.ny)) continue;
    const double share = (di == 1 ? px.share : 1 - px.share) * (dj == 1 ? py.share : 1 - py.share);
    const double value = height(map.levels[grid.column(static_cast<std::size_t>(i), static_cast<std::size_t>(j))]);
    if (std::isnan(value)) continue;
    sum += share * value;
    weight += share;
  }
  return weight > 0 && weight >= least_weight ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double LevelMap::at(double ColumnLevels::*height, double x, double y) const {
  const auto of_bed = [height](const ColumnLevels& column) { return column.*height; };
  const double any = between(*this, x, y, of_bed, 0);
  if (!std::isnan(any)) return between(*this, x, y, of_bed);
  // Dry all around: the floor. Beside a bed it may be the top of a wall.
  return between(*this, x, y, [height](const ColumnLevels& column) { return bed_of(column, height); });
}

const ColumnLevels* LevelMap::find(const SamplingGrid& like, std::size_t i, std::size_t j) const {
  const long a = static_cast<long>(i) + like.first_x - grid.first_x;
  const long b = grid.ny == 1 ? 0 : static_cast<long>(j) + like.first_y - grid.first_y;
  if (a < 0 || b < 0 || a >= static_cast<long>(grid.nx) || b >= static_cast<long>(grid.ny)) return nullptr;
  return &levels[grid.column(static_cast<std::size_t>(a), static_cast<std::size_t>(b))];
}

std::vector<BedHeights> bed_heights(const LevelMap& before, const LevelMap& after) {
  std::vector<BedHeights> heights(after.levels.size());
  for (std::size_t i = 0; i < after.grid.nx; ++i) {
    for (std::size_t j = 0; j < after.grid.ny; ++j) {
      const Change change = change_of(before, after, i, j, &ColumnLevels::bed);
      if (change.of_bed && !std::isnan(change.rise())) heights[after.grid.column(i, j)] = {change.before, change.now};
    }
  }
  return heights;
}

std::optional<BedBalance> bed_balance(const LevelMap& before, const LevelMap& after) {
  return Balance(before, after).take();
}

}  // namespace thalweg
