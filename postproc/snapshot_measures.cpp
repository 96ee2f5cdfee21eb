#include "postproc/snapshot_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "common/extraction/periodic_images.hpp"
#include "postproc/line_profile.hpp"

namespace thalweg {
namespace {

// A length rounded to the next power of ten below a millionth of the spacing.
double rounded(double length, double spacing) {
  const double digits = std::pow(10, 6 - std::floor(std::log10(spacing)));
  return std::round(length * digits) / digits;
}

// A profile without the digits that mean nothing.
Profile rounded(Profile profile, double spacing) {
  for (auto* values : {&profile.x, &profile.free_surface, &profile.bed, &profile.moving_bed, &profile.floor}) {
    for (double& value : *values) value = rounded(value, spacing);
  }
  return profile;
}

/// The particles and, where the domain repeats itself, the copies beside its ends.
std::optional<ParticleSet> repeated(const ParticleSet& particles, const MeasureSettings& settings) {
  const double reach = 2 * particles.info.smoothing_length + 2 * particles.info.spacing;
  return with_periodic_images(particles, settings.resolved.domain, reach);
}

CellList cells_of(const ParticleSet& particles) {
  const double edge = cell_edge(particles.info);
  return {particles.position, edge > 0 ? edge : 1};
}

}  // namespace

LevelMap levels_of(const ParticleSet& of_file, const MeasureSettings& settings) {
  const std::optional<ParticleSet> all = repeated(of_file, settings);
  const ParticleSet& particles = all ? *all : of_file;
  const ClassifiedParticles set(particles, settings.profile.rest_speed);
  const auto field = make_surface_field(set, cells_of(particles), settings.profile);
  return field ? level_map(*field) : LevelMap{};
}

SnapshotResults measure(const ParticleSet& of_file, double time, const MeasureSettings& settings,
                        const LevelMap* initial) {
  const std::optional<ParticleSet> all = repeated(of_file, settings);
  const ParticleSet& particles = all ? *all : of_file;
  const ClassifiedParticles set(particles, settings.profile.rest_speed);
  const double spacing = particles.info.spacing;
  SnapshotResults results;
  results.profiles.info = particles.info;
  SnapshotMeasures& measures = results.measures;
  measures.time = time;
  measures.rest_criterion = fmt::format(
      "{}speed below {:.3g} m/s", has_sediment_states(particles) ? "State deposit, " : "", settings.profile.rest_speed);

  const ExtractedProfile found = extract_profile(set, settings.profile);
  measures.front = rounded(found.front, spacing);
  results.profiles.along_x = rounded(found.profile, spacing);
  for (const ProfileLine& line : settings.lines) {
    results.profiles.lines.push_back(rounded(extract_along(particles, settings.profile, line), spacing));
  }
  if (!settings.resolved.gauges.empty()) measures.gauges = read_gauges(settings.resolved, particles);

  const CellList cells = cells_of(particles);
  if (const auto field = make_surface_field(set, cells, settings.profile)) {
    results.levels = level_map(*field);
    const LevelMap& before = initial != nullptr ? *initial : results.levels;
    if (field->bodies.sediment) measures.balance = bed_balance(before, results.levels);
    if (settings.surfaces) results.surfaces = make_surfaces(particles, cells, *field, before);
  }
  return results;
}

}  // namespace thalweg
