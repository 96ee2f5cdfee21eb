#include "postproc/bed_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "common/csv.hpp"
#include "common/extraction/parts.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void make_places(BedMap& map) {
  for (auto* values : {&map.before, &map.now, &map.water}) values->assign(map.size(), none);
  map.ground.assign(map.size(), Ground::bare);
}

/// Place of a point, or nothing outside the map.
std::optional<std::size_t> place_of(const BedMap& map, const Vec3& at) {
  const long i = std::lround((at.x() - map.x0) / map.step);
  const long j = map.ny == 1 ? 0 : std::lround((at.y() - map.y0) / map.step);
  if (i < 0 || j < 0 || i >= static_cast<long>(map.nx) || j >= static_cast<long>(map.ny)) return std::nullopt;
  return map.index(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
}

/// True for a place of the map with a bed; false beyond the map too, where the numbers wrap around.
bool is_bed(const BedMap& map, std::size_t i, std::size_t j) {
  return i < map.nx && j < map.ny && map.ground[map.index(i, j)] == Ground::bed &&
         !std::isnan(map.now[map.index(i, j)]);
}

/// Points of a survey for a place with a bed, in half steps from it: the place, and points towards where the bed ends.
std::vector<std::array<int, 2>> points_of_place(const BedMap& map, std::size_t i, std::size_t j) {
  std::vector<std::array<int, 2>> points{{0, 0}};
  const int most_north = map.ny == 1 ? 0 : 1;
  for (int east = -1; east <= 1; ++east) {
    for (int north = -most_north; north <= most_north; ++north) {
      const auto beside_i = i + static_cast<std::size_t>(east);
      const auto beside_j = j + static_cast<std::size_t>(north);
      const bool ends = (east == 0 || !is_bed(map, beside_i, j)) && (north == 0 || !is_bed(map, i, beside_j)) &&
                        !is_bed(map, beside_i, beside_j);
      if (ends) points.push_back({east, north});
    }
  }
  return points;
}

/// Calls `of` for all places within `reach` [m] of a point, along x and along y.
template <class Of>
void for_places(const BedMap& map, const Vec3& at, double reach, const Of& of) {
  const auto places = [&](double from_first, std::size_t count) {
    const auto below = static_cast<long>(std::ceil((from_first - reach) / map.step));
    const auto above = static_cast<long>(std::floor((from_first + reach) / map.step));
    return std::pair{std::max(0L, below), std::min(above, static_cast<long>(count) - 1)};
  };
  const auto [left, right] = places(at.x() - map.x0, map.nx);
  const auto [near, far] = map.ny == 1 ? std::pair{0L, 0L} : places(at.y() - map.y0, map.ny);
  for (long i = left; i <= right; ++i) {
    for (long j = near; j <= far; ++j) of(map.index(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
  }
}

/// Columns of a grid, from the first to the last that counts.
struct Range {
  std::size_t first = std::numeric_limits<std::size_t>::max();
  std::size_t last = 0;

  void take(std::size_t column) {
    first = std::min(first, column);
    last = std::max(last, column);
  }
  void widen(std::size_t columns) {
    first -= std::min<std::size_t>(first, 2);
    last = std::min(last + 2, columns - 1);
  }
  [[nodiscard]] bool is_empty() const { return first > last; }
  [[nodiscard]] std::size_t count() const { return last - first + 1; }
};

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
};

template <class Counts>
Extent extent_of(const ParticleSet& particles, const Counts& counts) {
  Extent extent;
  for (std::size_t n = 0; n < particles.size(); ++n) {
    if (!counts(particles.type[n])) continue;
    extent.low = extent.low.cwiseMin(particles.position[n]);
    extent.high = extent.high.cwiseMax(particles.position[n]);
  }
  return extent;
}

/// Raises the heights of a bed's columns to the tops of its particles.
void take_tops(const BedMap& map, const ParticleSet& particles, ParticleType type, std::vector<double>& heights) {
  for (std::size_t n = 0; n < particles.size(); ++n) {
    if (particles.type[n] != type) continue;
    const auto k = place_of(map, particles.position[n]);
    if (k) heights[*k] = std::fmax(heights[*k], particles.position[n].z() + particles.info.spacing / 2);
  }
}

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

}  // namespace

bool BedMap::has_bed() const {
  return std::any_of(ground.begin(), ground.end(), [](Ground kind) { return kind == Ground::bed; });
}

BedExtremes extremes_of(const BedMap& map) {
  BedExtremes found;
  const double area = map.ny == 1 ? map.step : map.step * map.step;
  bool first = true;
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      const double rise = map.change(map.index(i, j));
      if (std::isnan(rise)) continue;
      if (first) found.scour_at = found.deposition_at = {i, j};
      first = false;
      if (-rise > found.scour) found.scour = -rise, found.scour_at = {i, j};
      if (rise > found.deposition) found.deposition = rise, found.deposition_at = {i, j};
      found.eroded += area * std::max(0.0, -rise);
      found.deposited += area * std::max(0.0, rise);
    }
  }
  return found;
}

BedMap map_of_levels(const LevelMap& before, const LevelMap& now) {
  BedMap map;
  const SamplingGrid& grid = now.grid;
  map.step = grid.step;
  if (grid.nx == 0) return map;
  const std::vector<BedHeights> heights = bed_heights(before, now);
  // The grid reaches further than the scene: of its ends, what lies more than two columns away from bed and water is left out.
  Range along_x;
  Range along_y;
  for (std::size_t i = 0; i < grid.nx; ++i) {
    for (std::size_t j = 0; j < grid.ny; ++j) {
      const std::size_t column = grid.column(i, j);
      if (std::isnan(heights[column].now) && std::isnan(now.levels[column].free_surface)) continue;
      along_x.take(i);
      along_y.take(j);
    }
  }
  if (along_x.is_empty()) return map;
  along_x.widen(grid.nx);
  along_y.widen(grid.ny);
  map.nx = along_x.count();
  map.ny = along_y.count();
  map.x0 = grid.x(along_x.first);
  map.y0 = grid.y(along_y.first);
  make_places(map);
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      const std::size_t column = grid.column(along_x.first + i, along_y.first + j);
      const std::size_t k = map.index(i, j);
      map.before[k] = heights[column].before;
      map.now[k] = heights[column].now;
      map.water[k] = now.levels[column].free_surface;
      if (!std::isnan(map.change(k))) map.ground[k] = Ground::bed;
    }
  }
  return map;
}

BedMap map_of_columns(const ParticleSet& before, const ParticleSet& now) {
  BedMap map;
  map.in_columns = true;
  map.step = now.info.spacing;
  const Extent extent = extent_of(before, is_fluid);
  if (!(extent.low.x() <= extent.high.x())) return map;
  // The columns stand on the lattice; any of their particles tells where it lies.
  const auto bed = std::find(before.type.begin(), before.type.end(), ParticleType::sediment);
  if (bed == before.type.end()) return map;
  const Vec3& column = before.position[static_cast<std::size_t>(bed - before.type.begin())];
  const auto steps_below = [&](int axis) { return std::floor((column[axis] - extent.low[axis]) / map.step + 1e-6); };
  const auto steps_above = [&](int axis) { return std::floor((extent.high[axis] - column[axis]) / map.step + 1e-6); };
  map.x0 = column.x() - map.step * steps_below(0);
  map.nx = static_cast<std::size_t>(steps_below(0) + steps_above(0)) + 1;
  if (now.info.dimension == 3) {
    map.y0 = column.y() - map.step * steps_below(1);
    map.ny = static_cast<std::size_t>(steps_below(1) + steps_above(1)) + 1;
  }
  make_places(map);
  take_tops(map, before, ParticleType::sediment, map.before);
  take_tops(map, now, ParticleType::sediment, map.now);
  take_tops(map, now, ParticleType::water, map.water);
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (!std::isnan(map.change(k))) map.ground[k] = Ground::bed;
  }
  return map;
}

void add_ground(BedMap& map, const ParticleSet& particles) {
  const Extent fluid = extent_of(particles, is_fluid);
  const double spacing = particles.info.spacing;
  // A particle fills a square of one spacing: all places on it, of which a lattice half a spacing off has several.
  constexpr double reach = 0.501;  // [spacings]
  std::vector<double> tops(map.size(), none);
  std::vector<Ground> kinds(map.size(), Ground::bare);
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const Vec3& at = particles.position[n];
    if (!is_wall(particles.type[n]) || at.z() < fluid.low.z() || at.z() > fluid.high.z()) continue;
    const auto inside = [&](int axis) {
      return at[axis] > fluid.low[axis] + spacing && at[axis] < fluid.high[axis] - spacing;
    };
    const Ground kind = inside(0) && (map.ny == 1 || inside(1)) ? Ground::body : Ground::wall;
    for_places(map, at, reach * spacing, [&](std::size_t k) {
      tops[k] = std::fmax(tops[k], at.z());
      kinds[k] = std::max(kinds[k], kind);
    });
  }
  // A wall ends the water; a floor has water over it. Particles beside a wall may lie over its edge.
  constexpr double run_up = 2;  // [spacings]
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (map.ground[k] == Ground::bed || std::isnan(tops[k])) continue;
    if (std::isnan(map.water[k]) || tops[k] > map.water[k] - run_up * spacing) map.ground[k] = kinds[k];
  }
}

void add_shields(BedMap& map, const ParticleSet& particles, double grain_weight) {
  const auto numbers = particles.scalars.find("ShieldsNumber");
  const auto stresses = particles.scalars.find("BedShear");
  const bool of_columns = map.in_columns && stresses != particles.scalars.end();
  if (!(grain_weight > 0) || (!of_columns && numbers == particles.scalars.end())) return;
  const std::vector<float>& values = of_columns ? stresses->second : numbers->second;
  const double unit = of_columns ? grain_weight : 1;
  std::vector<double> sum(map.size(), 0);
  std::vector<double> count(map.size(), 0);
  // Grains lie anywhere, the top rows of columns at their middles.
  const double reach = (of_columns ? 0.25 : 1) * particles.info.spacing;
  for (std::size_t n = 0; n < particles.size(); ++n) {
    if (particles.type[n] != ParticleType::sediment || !(values[n] > 0)) continue;
    for_places(map, particles.position[n], reach, [&](std::size_t k) {
      sum[k] += values[n] / unit;
      count[k] += 1;
    });
  }
  map.shields.assign(map.size(), none);
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (map.ground[k] == Ground::bed) map.shields[k] = count[k] > 0 ? sum[k] / count[k] : 0;
  }
}

void write_bed_map(const std::filesystem::path& file, const BedMap& map, double grain_weight) {
  CsvTable table({{"x", "m"},
                  {"y", "m"},
                  {"before", "m"},
                  {"now", "m"},
                  {"change", "m"},
                  {"water", "m"},
                  {"shields", "-"},
                  {"shear", "Pa"},
                  {"ground", "-"}});
  table.comments.push_back(
      fmt::format("the bed at t = {:g} s; ground: 0 bed, 1 bare or dry, 2 wall, 3 body", map.time));
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      const std::size_t k = map.index(i, j);
      const double shields = map.shields.empty() ? none : map.shields[k];
      table.add_row({csv_number(map.x(i)), csv_number(map.y(j)), cell(map.before[k]), cell(map.now[k]),
                     cell(map.change(k)), cell(map.water[k]), cell(shields), cell(shields * grain_weight),
                     std::to_string(static_cast<int>(map.ground[k]))});
    }
  }
  table.write(file);
}

void write_bed_survey(const std::filesystem::path& file, const BedMap& map, const Vec3& low, const Vec3& high) {
  const bool in_plane = map.ny == 1;
  CsvTable table(in_plane ? std::vector<CsvColumn>{{"x", "m"}, {"z", "m"}}
                          : std::vector<CsvColumn>{{"x", "m"}, {"y", "m"}, {"z", "m"}});
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      if (!is_bed(map, i, j)) continue;
      for (const auto& [east, north] : points_of_place(map, i, j)) {
        const double x = map.x(i) + 0.5 * east * map.step;
        const double y = map.y(j) + 0.5 * north * map.step;
        const double rounding = 1e-6 * map.step;
        if (x < low.x() - rounding || x > high.x() + rounding) continue;
        if (!in_plane && (y < low.y() - rounding || y > high.y() + rounding)) continue;
        std::vector<std::string> row{csv_number(x)};
        if (!in_plane) row.push_back(csv_number(y));
        row.push_back(csv_number(map.now[map.index(i, j)]));
        table.add_row(row);
      }
    }
  }
  table.write(file);
}

void write_contours(const std::filesystem::path& file, const std::vector<Contour>& contours) {
  write_whole_text(file, [&](std::ostream& to) {
    to << "level [m],x [m],y [m]\n";
    for (const Contour& contour : contours) {
      for (const auto& point : contour.points)
        to << fmt::format("{:.6g},{:.6g},{:.6g}\n", contour.level, point[0], point[1]);
      to << "\n";
    }
  });
}

}  // namespace thalweg
