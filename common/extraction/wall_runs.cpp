#include "common/extraction/wall_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/extraction/parts.hpp"

namespace thalweg {
namespace {

// Columns of one spacing are counted from half a spacing, so that rounding never splits the particles of one column of
// a lattice anchored at multiples of the spacing (or half of it).
long column_of(double coordinate, double spacing) { return std::lround(std::floor(coordinate / spacing + 1e-3)); }

struct Members {
  std::vector<std::size_t> particles;
  double lowest_top = 0;
};

}  // namespace

std::vector<double> WallRuns::moving_tops(double x, double y) const {
  const long i = column_of(x, spacing);
  const long j = column_of(y, spacing);
  std::vector<double> tops;
  for (const auto& [di, dj] : {std::pair{0L, 0L}, {-1L, 0L}, {1L, 0L}, {0L, -1L}, {0L, 1L}}) {
    const auto found = columns.find({i + di, j + dj});
    if (found == columns.end()) continue;
    tops.insert(tops.end(), found->second.moving_tops.begin(), found->second.moving_tops.end());
  }
  return tops;
}

double WallRuns::floor(double x, double y) const {
  const auto found = columns.find({column_of(x, spacing), column_of(y, spacing)});
  const bool known = found != columns.end() && found->second.moving_tops.empty();
  return known ? found->second.floor : std::numeric_limits<double>::quiet_NaN();
}

WallRuns find_wall_runs(const ParticleSet& particles, double spacing) {
  WallRuns runs;
  runs.spacing = spacing;
  runs.top.assign(particles.size(), std::numeric_limits<double>::quiet_NaN());
  std::map<std::pair<long, long>, Members> columns;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!is_wall(particles.type[i])) continue;
    const Vec3& at = particles.position[i];
    columns[{column_of(at.x(), spacing), column_of(at.y(), spacing)}].particles.push_back(i);
  }
  if (columns.empty()) return runs;

  // A lifted gate must not make the flume's walls look low: moving walls bound the flow only if there is no fixed one.
  const bool any_fixed =
      std::find(particles.type.begin(), particles.type.end(), ParticleType::wall) != particles.type.end();
  const auto bounds_flow = [&](std::size_t i) { return !any_fixed || particles.type[i] == ParticleType::wall; };
  double highest = -std::numeric_limits<double>::infinity();
  for (auto& [place, column] : columns) {
    std::vector<std::size_t>& members = column.particles;
    const auto height = [&](std::size_t i) { return particles.position[i].z(); };
    std::sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
    std::size_t first = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const bool run_ends = k + 1 == members.size() || height(members[k + 1]) - height(members[k]) > 2 * spacing;
      if (!run_ends) continue;
      const double top = height(members[k]) + spacing / 2;
      for (std::size_t m = first; m <= k; ++m) runs.top[members[m]] = top;
      if (first == 0) column.lowest_top = runs.columns[place].floor = top;
      const auto moves = [&](std::size_t m) { return particles.type[m] == ParticleType::moving_wall; };
      if (moves(members[k])) runs.columns[place].moving_tops.push_back(top);
      if (bounds_flow(members[k])) highest = std::max(highest, top);
      first = k + 1;
    }
  }

  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (const auto& [place, column] : columns) {
    if (column.lowest_top > highest - spacing) continue;
    from = std::min(from, static_cast<double>(place.first) * spacing);
    to = std::max(to, static_cast<double>(place.first + 1) * spacing);
  }
  if (from < to) {
    runs.open_from = from;
    runs.open_to = to;
  }
  return runs;
}

}  // namespace thalweg
