#include "postproc/extraction_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

ExtractionSettings settings_of(const Case& resolved) {
  ExtractionSettings settings;
  settings.x_from = resolved.domain.from.x();
  settings.x_to = resolved.domain.to.x();
  settings.z_from = resolved.domain.from.z();
  settings.z_to = resolved.domain.to.z();
  if (resolved.info.dimension == 3) settings.plane_y = (resolved.domain.from.y() + resolved.domain.to.y()) / 2;
  settings.rest_speed = rest_speed_of(resolved);
  return settings;
}

// A length to the power of ten next below a millionth of the spacing.
double rounded(double length, double spacing) {
  const double digits = std::pow(10, 6 - std::floor(std::log10(spacing)));
  return std::round(length * digits) / digits;
}

std::vector<std::string> comments_of(const ParticleSet& particles, const ExtractionSettings& settings,
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
  if (info.dimension == 3) comments.push_back(fmt::format("in the plane y = {:g} m", settings.plane_y));
  return comments;
}

void write_fronts(const fs::path& file, const std::vector<FrontSample>& fronts, double spacing) {
  CsvTable table({{"time", "s"}, {"front", "m"}});
  table.comments.push_back(
      fmt::format("largest x with more than {:g} m of water over the bed ({:g} of the particle spacing)",
                  least_layer * spacing, least_layer));
  for (const FrontSample& sample : fronts) {
    table.add_row({csv_number(sample.time), csv_number(rounded(sample.front, spacing))});
  }
  table.write(file);
}

// A profile's numbers without the digits that mean nothing.
Profile rounded(Profile profile, double spacing) {
  for (auto* values : {&profile.x, &profile.free_surface, &profile.bed, &profile.moving_bed}) {
    for (double& value : *values) value = rounded(value, spacing);
  }
  return profile;
}

// One snapshot into the record, and into a file if the case asks for its time.
void add_snapshot(const ParticleSet& particles, double time, const RunFolder& run, const ExtractionSettings& settings,
                  const std::vector<double>& times, ExtractionRun& record) {
  ExtractedProfile found = extract_profile(particles, settings);
  found.profile = rounded(std::move(found.profile), particles.info.spacing);
  record.fronts.push_back({time, found.front});
  record.info = particles.info;
  record.last_time = time;
  record.rest_criterion = fmt::format("{}speed below {:.3g} m/s",
                                      has_sediment_states(particles) ? "State deposit, " : "", settings.rest_speed);
  const bool asked =
      std::any_of(times.begin(), times.end(), [&](double wanted) { return std::abs(wanted - time) <= same_time; });
  const fs::path file = run.profiles() / profile_file_name(time);
  if (asked) {
    write_profile(file, found.profile, comments_of(particles, settings, record.rest_criterion));
    record.written.push_back({time, file, found.profile});
  }
  if (!record.initial) record.initial = TimedProfile{time, {}, std::move(found.profile)};
}

// Profiles of an earlier pass, perhaps at other times, would be taken for results of this one.
void remove_profiles(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (time_of_profile(entry.path())) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
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

ExtractionRun extract_run(const RunFolder& run, const Case& resolved) {
  const SnapshotList list = find_snapshots(run);
  const ExtractionSettings settings = settings_of(resolved);
  ExtractionRun record;
  record.warnings = list.warnings;
  record.damaged = list.damaged;
  record.plane_y = settings.plane_y;

  remove_profiles(run.profiles());

  std::vector<double> times = resolved.compare.times;
  if (times.empty() && !list.entries.empty()) times.push_back(list.entries.back().time);
  for (const SeriesEntry& entry : list.entries) {
    try {
      const ParticleSet particles = read_particles(entry.file);
      add_snapshot(particles, entry.time, run, settings, times, record);
      record.last_snapshot = entry.file;
    } catch (const InputError& error) {
      record.warnings.emplace_back(std::string("skipped: ") + error.what());
      record.damaged = true;
    }
  }
  if (record.fronts.empty()) {
    throw InputError(run.root.string() + ": none of its snapshots can be read (" + record.warnings.back() +
                     "); compute them again with thalweg-solver " + run.root.string());
  }
  for (const double time : times) {
    const bool there = std::any_of(record.written.begin(), record.written.end(),
                                   [&](const TimedProfile& timed) { return std::abs(timed.time - time) <= same_time; });
    if (there) continue;
    record.warnings.push_back(
        fmt::format("no snapshot at t = {:g} s, which compare.times asks for: the run ends at {:g} s "
                    "or has a gap there",
                    time, record.last_time));
    record.damaged = true;
  }
  write_fronts(run.profiles() / "front.csv", record.fronts, record.info.spacing);
  return record;
}

}  // namespace thalweg
