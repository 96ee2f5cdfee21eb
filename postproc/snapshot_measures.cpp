#include "postproc/snapshot_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "postproc/line_profile.hpp"
#include "postproc/surfaces.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// A length to the power of ten next below a millionth of the spacing.
double rounded(double length, double spacing) {
  const double digits = std::pow(10, 6 - std::floor(std::log10(spacing)));
  return std::round(length * digits) / digits;
}

// A profile's numbers without the digits that mean nothing.
Profile rounded(Profile profile, double spacing) {
  for (auto* values : {&profile.x, &profile.free_surface, &profile.bed, &profile.moving_bed}) {
    for (double& value : *values) value = rounded(value, spacing);
  }
  return profile;
}

std::vector<std::string> comments_of(const ParticleSet& particles, const std::string& place,
                                     const std::string& rest_criterion) {
  const ParticleFileInfo& info = particles.info;
  std::vector<std::string> comments{
      fmt::format("case {}, t = {:g} s, step {}, particle spacing {:g} m, smoothing length {:g} m", info.case_name,
                  info.time, info.step, info.spacing, info.smoothing_length),
      fmt::format("written by thalweg-postproc " THALWEG_VERSION " from a run of thalweg {} on the case with hash {}",
                  info.code_version, info.case_hash),
      fmt::format(
          "method: 0.5 crossing of the kernel sum of volume (Wendland C2, h = {:g} m) on a grid of {:g} m, bodies "
          "connected to the floor only, highest crossing in each column",
          info.smoothing_length, info.spacing / 2),
      fmt::format("moving_bed: upper edge of the sediment at rest ({}); layers below {:g} spacing count as absent",
                  rest_criterion, least_layer)};
  if (!place.empty()) comments.push_back(place);
  return comments;
}

CellList cells_of(const ParticleSet& particles) {
  const double edge = cell_edge(particles.info);
  return {particles.position, edge > 0 ? edge : 1};
}

void write_surfaces(const ParticleSet& particles, const CellList& cells, const SurfaceField& field,
                    const LevelMap& initial, const SnapshotFiles& files) {
  for (const Surface& surface : make_surfaces(particles, cells, field, initial)) {
    write_surface(files.surface(name_of(surface.kind), ".vtp"), surface, particles.info);
    if (particles.info.dimension == 3) write_stl(files.surface(name_of(surface.kind), ".stl"), surface);
  }
}

}  // namespace

double rest_speed_of(const Case& resolved) {
  if (resolved.sediments.empty()) return ExtractionSettings{}.rest_speed;
  constexpr double share = 0.05;
  double smallest_grain = std::numeric_limits<double>::infinity();
  for (const auto& [name, sediment] : resolved.sediments) {
    smallest_grain = std::min(smallest_grain, sediment.grain_diameter);
  }
  return share * std::sqrt(resolved.domain.gravity.norm() * smallest_grain);
}

MeasureSettings settings_of(const Case& resolved, const std::vector<ProfileLine>& further_lines, bool surfaces) {
  MeasureSettings settings{resolved, {}, resolved.lines, surfaces};
  settings.lines.insert(settings.lines.end(), further_lines.begin(), further_lines.end());
  settings.profile.x_from = resolved.domain.from.x();
  settings.profile.x_to = resolved.domain.to.x();
  settings.profile.z_from = resolved.domain.from.z();
  settings.profile.z_to = resolved.domain.to.z();
  if (resolved.info.dimension == 3) {
    settings.profile.plane_y = (resolved.domain.from.y() + resolved.domain.to.y()) / 2;
  }
  settings.profile.rest_speed = rest_speed_of(resolved);
  return settings;
}

fs::path SnapshotFiles::surface(const char* kind, const char* extension) const {
  return surface_stem.parent_path() / (kind + surface_stem.filename().string() + extension);
}

SnapshotFiles files_at(double time, const RunFolder& run, const MeasureSettings& settings) {
  const fs::path name = profile_file_name(time);
  SnapshotFiles files{run.profiles() / "all" / name, {}, run.surfaces() / ("_" + name.stem().string())};
  for (const ProfileLine& line : settings.lines) files.lines.push_back(run.profiles() / line.name / name);
  return files;
}

LevelMap initial_levels(const ParticleSet& particles, const MeasureSettings& settings) {
  const auto field = make_surface_field(particles, cells_of(particles), settings.profile);
  return field ? level_map(*field) : LevelMap{};
}

SnapshotMeasures measure_snapshot(const ParticleSet& particles, double time, const RunFolder& run,
                                  const MeasureSettings& settings, const LevelMap* initial, LevelMap* own) {
  const SnapshotFiles files = files_at(time, run, settings);
  const double spacing = particles.info.spacing;
  SnapshotMeasures measures;
  measures.time = time;
  measures.rest_criterion = fmt::format(
      "{}speed below {:.3g} m/s", has_sediment_states(particles) ? "State deposit, " : "", settings.profile.rest_speed);

  const ExtractedProfile found = extract_profile(particles, settings.profile);
  measures.front = rounded(found.front, spacing);
  const std::string plane =
      particles.info.dimension == 3 ? fmt::format("in the plane y = {:g} m", settings.profile.plane_y) : "";
  write_profile(files.profile, rounded(found.profile, spacing), comments_of(particles, plane, measures.rest_criterion));
  for (std::size_t n = 0; n < settings.lines.size(); ++n) {
    const ProfileLine& line = settings.lines[n];
    write_profile(files.lines[n], rounded(extract_along(particles, settings.profile, line), spacing),
                  comments_of(particles, description_of(line), measures.rest_criterion));
  }
  if (!settings.resolved.gauges.empty()) measures.gauges = read_gauges(settings.resolved, particles);

  const CellList cells = cells_of(particles);
  if (const auto field = make_surface_field(particles, cells, settings.profile)) {
    LevelMap now = level_map(*field);
    const LevelMap& before = initial != nullptr ? *initial : now;
    if (field->bodies.sediment) measures.balance = bed_balance(before, now);
    if (settings.surfaces) write_surfaces(particles, cells, *field, before, files);
    if (own != nullptr) *own = std::move(now);
  }
  return measures;
}

}  // namespace thalweg
