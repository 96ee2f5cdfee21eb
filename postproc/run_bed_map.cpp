#include "postproc/run_bed_map.hpp"

#include <algorithm>
#include <cmath>

#include "case/models/grains.hpp"
#include "case/models/surface_bed.hpp"
#include "common/io/particle_file.hpp"
#include "postproc/measure_settings.hpp"
#include "postproc/snapshot_measures.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

/// Stress at which a flat bed begins to move [Pa]; Shields' curve gives it by the friction velocity that it has itself.
double critical_stress_of(const Grains& grains, double weight) {
  if (grains.critical_shields > 0) return grains.critical_shields * weight;
  double shields = 0.05;  // on the curve's flat part
  constexpr int enough = 50;
  for (int n = 0; n < enough; ++n) {
    const double friction_velocity = std::sqrt(shields * weight / grains.water_density);
    shields = bed_stress_of(grains, friction_velocity, 1, 0).flat_critical;
  }
  return shields * weight;
}

bool has_water(const Case& of) {
  return !of.inlets.empty() ||
         std::any_of(of.shapes.begin(), of.shapes.end(), [](const Shape& s) { return s.role == ShapeRole::water; });
}

BedMap contoured_map(const Case& resolved, const ExtractionRun& extraction, const SnapshotList& snapshots,
                     const ParticleSet& last) {
  const MeasureSettings settings = settings_of(resolved, {}, false);
  const LevelMap before = extraction.initial_levels != nullptr ? *extraction.initial_levels
                                                               : levels_of(first_readable(snapshots.entries), settings);
  const LevelMap now = extraction.last_levels != nullptr ? *extraction.last_levels : levels_of(last, settings);
  return map_of_levels(before, now);
}

/// Number of the place, of `count` in a direction of the domain, whose height stands for that of place n.
std::size_t place_clear_of_sides(std::size_t n, std::size_t count, double first, double step, double from, double to,
                                 double reach) {
  const double at = first + step * static_cast<double>(n);
  if (to - from < 2 * reach || (at >= from + reach && at <= to - reach)) return n;
  const double clear = std::round((std::clamp(at, from + reach, to - reach) - first) / step);
  return static_cast<std::size_t>(std::clamp(clear, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

BedMap make_survey_map(const Case& resolved, const RunFolder& run, const ExtractionRun& extraction) {
  BedMap map = make_run_bed_map(resolved, run, extraction).map;
  if (map.in_columns || resolved.domain.periodic.empty()) return map;
  const bool round_x = resolved.domain.is_periodic(0);
  const bool round_y = resolved.domain.is_periodic(1);
  const Vec3& from = resolved.domain.from;
  const Vec3& to = resolved.domain.to;
  const double reach = 2 * resolved.smoothing_length();
  const BedMap found = map;
  for (std::size_t i = 0; i < map.nx; ++i) {
    for (std::size_t j = 0; j < map.ny; ++j) {
      const std::size_t x = round_x ? place_clear_of_sides(i, map.nx, map.x0, map.step, from.x(), to.x(), reach) : i;
      const std::size_t y =
          round_y && map.ny > 1 ? place_clear_of_sides(j, map.ny, map.y0, map.step, from.y(), to.y(), reach) : j;
      map.now[map.index(i, j)] = found.now[map.index(x, y)];
      map.ground[map.index(i, j)] = found.ground[map.index(x, y)];
    }
  }
  return map;
}

RunBedMap make_run_bed_map(const Case& resolved, const RunFolder& run, const ExtractionRun& extraction) {
  RunBedMap found;
  if (!resolved.has_sediment()) return found;
  const SnapshotList snapshots = find_snapshots(run);
  const ParticleSet last = read_particles(extraction.last_snapshot);
  found.map = models::SurfaceBedOfCase::is_on(resolved) ? map_of_columns(first_readable(snapshots.entries), last)
                                                        : contoured_map(resolved, extraction, snapshots, last);
  found.map.time = extraction.last_time;
  if (found.map.size() == 0 || !found.map.has_bed()) return {};
  add_ground(found.map, last);
  if (!has_water(resolved) || resolved.sediments.size() != 1) return found;
  const Grains grains = grains_of(resolved);
  found.grain_weight = grain_weight_stress(grains.density, grains.water_density, grains.gravity, grains.diameter);
  add_shields(found.map, last, found.grain_weight);
  // A part of the stress may be that of ripples, which moves no grains.
  found.critical_stress = critical_stress_of(grains, found.grain_weight) / grain_stress_of(resolved);
  return found;
}

}  // namespace thalweg
