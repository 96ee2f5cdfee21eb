#include "common/extraction/wall_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/extraction/parts.hpp"
#include "common/extraction/wall_gaps.hpp"

namespace thalweg {
namespace {

constexpr double same_place = 0.01;  // [-] of the spacing

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
  runs.doubled.assign(particles.size(), 0);
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
  RunsOfColumns found;
  for (auto& [place, column] : columns) {
    std::vector<std::size_t>& members = column.particles;
    const auto height = [&](std::size_t k) { return particles.position[members[k]].z(); };
    std::sort(members.begin(), members.end(),
              [&](std::size_t a, std::size_t b) { return particles.position[a].z() < particles.position[b].z(); });
    for (std::size_t k = 1; k < members.size(); ++k) {
      const double apart = (particles.position[members[k]] - particles.position[members[k - 1]]).norm();
      runs.doubled[members[k]] = apart < same_place * spacing ? 1 : 0;
    }
    double low = height(0) - spacing / 2;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const bool run_ends = k + 1 == members.size() || height(k + 1) - height(k) > 2 * spacing;
      if (!run_ends) continue;
      found[place].push_back({low, height(k) + spacing / 2, k + 1});
      if (k + 1 < members.size()) low = height(k + 1) - spacing / 2;
    }
  }
  join_hollow_walls(particles, spacing, found);

  double highest = -std::numeric_limits<double>::infinity();
  for (auto& [place, column] : columns) {
    const std::vector<WallRun>& of_column = found.at(place);
    column.lowest_top = runs.columns[place].floor = of_column.front().high;
    std::size_t first = 0;
    for (const WallRun& run : of_column) {
      for (std::size_t m = first; m < run.members; ++m) runs.top[column.particles[m]] = run.high;
      const std::size_t upper = column.particles[run.members - 1];
      if (particles.type[upper] == ParticleType::moving_wall) runs.columns[place].moving_tops.push_back(run.high);
      if (bounds_flow(upper)) highest = std::max(highest, run.high);
      first = run.members;
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
