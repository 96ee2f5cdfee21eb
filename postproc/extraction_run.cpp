#include "postproc/extraction_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/whole_file.hpp"
#include "postproc/measure_pass.hpp"
#include "postproc/scour_record.hpp"
#include "postproc/snapshot_files.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Writes the series of the surfaces that exist, and removes a series without surfaces.
void write_surface_series(const RunFolder& run, const std::vector<MeasuredSnapshot>& done,
                          const MeasureSettings& settings) {
  for (const SurfaceKind kind : surface_kinds) {
    std::vector<SeriesEntry> entries;
    for (const MeasuredSnapshot& snapshot : done) {
      const double time = snapshot.measures.time;
      const fs::path file = files_at(time, run, settings).surface(kind, ".vtp");
      if (fs::exists(file)) entries.push_back({time, file.filename()});
    }
    const fs::path series = run.surfaces() / (std::string(name_of(kind)) + ".pvd");
    if (entries.empty()) {
      fs::remove(series);
    } else {
      write_series(series, entries);
    }
  }
}

void copy_whole(const fs::path& from, const fs::path& to) {
  write_whole_file(to, [&](const fs::path& temporary) { fs::copy_file(from, temporary); });
}

[[noreturn]] void refuse_run(const RunFolder& run, const std::vector<std::string>& warnings) {
  throw InputError(run.root.string() + ": none of its snapshots can be read (" + warnings.back() +
                   "); compute them again with thalweg-solver " + run.root.string());
}

bool is_at(double time, double wanted) { return std::abs(wanted - time) <= same_time; }

SnapshotProfile snapshot_profile(const fs::path& file, const Profile* measured) {
  return {time_of_profile(file).value(), file, measured != nullptr ? std::make_optional(*measured) : std::nullopt};
}

// The profiles of all snapshots, along x and along the lines.
void take_profiles(const RunFolder& run, const MeasureSettings& settings, const std::vector<MeasuredSnapshot>& done,
                   ExtractionRun& record) {
  for (const MeasuredSnapshot& snapshot : done) {
    const SnapshotFiles files = files_at(snapshot.measures.time, run, settings);
    const SnapshotProfiles* measured = snapshot.profiles.get();
    record.along_x.push_back(snapshot_profile(files.profile, measured != nullptr ? &measured->along_x : nullptr));
    for (std::size_t n = 0; n < settings.lines.size(); ++n) {
      record.along_lines[settings.lines[n].name].push_back(
          snapshot_profile(files.lines[n], measured != nullptr ? &measured->lines[n] : nullptr));
    }
  }
}

// Copies a snapshot's profile beside profiles/all, under a time that was asked for.
void take_profile(const RunFolder& run, const SnapshotProfile& profile, double time, ExtractionRun& record) {
  const fs::path file = run.profiles() / profile_file_name(time);
  copy_whole(profile.file, file);
  record.written.push_back({time, file, profile.get().profile});
}

// Takes the first snapshot after each of the bed's times asked for, and names the times that it has not come to.
void take_bed_times(const RunFolder& run, const Case& resolved, ExtractionRun& record) {
  const ScourRecord scour = read_scour(resolved, run.history());
  for (const double wanted : resolved.compare.bed_times) {
    const auto found = std::find_if(record.along_x.begin(), record.along_x.end(), [&](const SnapshotProfile& profile) {
      return bed_time_at(scour, profile.time) >= wanted * (1 - 1e-7);
    });
    if (found != record.along_x.end()) {
      take_profile(run, *found, wanted, record);
      continue;
    }
    record.warnings.push_back(fmt::format(
        "no snapshot at the bed's time {:g} s, which compare.bed_times asks for: the run's last is at {:g} s of it",
        wanted, bed_time_at(scour, record.last_time)));
    record.damaged = true;
  }
}

// Copies the profiles at the times asked for, beside profiles/all, and names the times without a snapshot.
void take_times_asked_for(const RunFolder& run, const std::vector<MeasuredSnapshot>& done,
                          const std::vector<double>& times, ExtractionRun& record) {
  for (std::size_t n = 0; n < done.size(); ++n) {
    const double time = done[n].measures.time;
    if (std::none_of(times.begin(), times.end(), [&](double wanted) { return is_at(time, wanted); })) continue;
    take_profile(run, record.along_x[n], time, record);
  }
  for (const double wanted : times) {
    const bool there = std::any_of(record.written.begin(), record.written.end(),
                                   [&](const TimedProfile& timed) { return is_at(timed.time, wanted); });
    if (there) continue;
    record.warnings.push_back(
        fmt::format("no snapshot at t = {:g} s, which compare.times asks for: the run ends at {:g} s "
                    "or has a gap there",
                    wanted, record.last_time));
    record.damaged = true;
  }
}

}  // namespace

TimedProfile SnapshotProfile::get() const { return {time, file, measured ? *measured : read_profile(file)}; }

ExtractionRun extract_run(const RunFolder& run, const Case& resolved, const ExtractionOptions& options) {
  const SnapshotList list = find_snapshots(run);
  const MeasureSettings settings = settings_of(resolved, options.lines, options.surfaces);
  ExtractionRun record;
  record.warnings = list.warnings;
  record.damaged = list.damaged;
  record.plane_y = settings.profile.plane_y;
  if (list.entries.empty()) refuse_run(run, record.warnings);

  MeasurePass pass(run, settings, list.entries);
  pass.run();
  record.warnings.insert(record.warnings.end(), pass.warnings().begin(), pass.warnings().end());
  record.damaged = record.damaged || !pass.warnings().empty();
  record.reused = pass.reused();
  record.initial_levels = pass.initial_levels();
  record.last_levels = pass.last_levels();
  const std::vector<MeasuredSnapshot> done = pass.done();
  if (done.empty()) refuse_run(run, record.warnings);

  const MeasuredSnapshot& last = done.back();
  record.last_snapshot = run.root / last.file;
  record.last_time = last.measures.time;
  record.rest_criterion = last.measures.rest_criterion;
  record.info = last.profiles ? last.profiles->info : read_particle_info(record.last_snapshot);
  for (const MeasuredSnapshot& snapshot : done) {
    record.fronts.push_back({snapshot.measures.time, snapshot.measures.front});
    record.balances.push_back({snapshot.measures.time, snapshot.measures.balance});
  }
  take_profiles(run, settings, done, record);
  record.initial = TimedProfile{done.front().measures.time, {}, record.along_x.front().get().profile};
  if (!resolved.compare.bed_times.empty()) {
    take_bed_times(run, resolved, record);
  } else {
    const double last_time = list.entries.back().time;
    take_times_asked_for(run, done, resolved.compare.times.empty() ? std::vector{last_time} : resolved.compare.times,
                         record);
  }

  write_measures(run, done, resolved, record.info.spacing);
  if (settings.surfaces) write_surface_series(run, done, settings);
  return record;
}

bool has_front(const ExtractionRun& extraction) {
  return std::any_of(extraction.fronts.begin(), extraction.fronts.end(),
                     [](const FrontSample& sample) { return !std::isnan(sample.front); });
}

}  // namespace thalweg
