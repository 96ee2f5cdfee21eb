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

}  // namespace

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
