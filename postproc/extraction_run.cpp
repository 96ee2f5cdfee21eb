#include "postproc/extraction_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/memory.hpp"
#include "common/whole_file.hpp"
#include "postproc/measure_tables.hpp"
#include "postproc/progress.hpp"
#include "postproc/snapshots.hpp"
#include "postproc/surfaces.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Measures the snapshots of a run that no earlier pass has measured.
class Pass {
 public:
  Pass(const RunFolder& run, const MeasureSettings& settings, const std::vector<SeriesEntry>& entries)
      : run_(run), settings_(settings), entries_(entries), progress_(entries.size()) {
    made_with_ = description();
    for (MeasuredSnapshot& snapshot : read_progress(progress_file(), made_with_, settings.resolved)) {
      const bool there = snapshot.version == version_of(run.root / snapshot.file) && has_results(snapshot);
      if (there) known_[snapshot.file] = std::move(snapshot);
    }
    remove_others();
  }

  void run() {
    std::vector<const SeriesEntry*> open;
    for (const SeriesEntry& entry : entries_) {
      const auto found = known_.find(name_of_file(entry));
      if (found == known_.end()) {
        open.push_back(&entry);
      } else {
        done_[entry.file] = found->second;
        ++reused_;
      }
    }
    if (!open.empty() && prepare()) measure(open);
    progress_.finish();
  }

  /// In the order of the snapshots.
  [[nodiscard]] std::vector<MeasuredSnapshot> done() const {
    std::vector<MeasuredSnapshot> all;
    for (const SeriesEntry& entry : entries_) {
      if (const auto found = done_.find(entry.file); found != done_.end()) all.push_back(found->second);
    }
    return all;
  }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] std::size_t reused() const { return reused_; }

 private:
  struct Outcome {
    const SeriesEntry* entry;
    MeasuredSnapshot measured;
    std::string failure;  // empty: measured
  };

  [[nodiscard]] fs::path progress_file() const { return run_.profiles() / "progress.csv"; }
  [[nodiscard]] std::string name_of_file(const SeriesEntry& entry) const {
    return entry.file.lexically_relative(run_.root).generic_string();
  }

  // All that the results depend on besides their snapshot.
  [[nodiscard]] std::string description() const {
    std::string text = fmt::format(
        "made by thalweg-postproc " THALWEG_VERSION " from the case {}, first snapshot {}; surfaces {}",
        hash_of(settings_.resolved), version_of(entries_.front().file), settings_.surfaces ? "written" : "not written");
    for (const ProfileLine& line : settings_.lines) {
      text += fmt::format("; {} {} {}", line.name, fmt::join(line.from, " "), fmt::join(line.to, " "));
    }
    return text;
  }

  [[nodiscard]] std::vector<fs::path> results_of(double time) const {
    const SnapshotFiles files = files_at(time, run_, settings_);
    std::vector<fs::path> paths{files.profile};
    paths.insert(paths.end(), files.lines.begin(), files.lines.end());
    return paths;
  }

  [[nodiscard]] bool has_results(const MeasuredSnapshot& snapshot) const {
    const std::vector<fs::path> paths = results_of(snapshot.measures.time);
    return std::all_of(paths.begin(), paths.end(), [](const fs::path& path) { return fs::exists(path); });
  }

  // Results of an earlier pass, perhaps at other times, would be taken for results of this one.
  void remove_others() const {
    std::set<fs::path> kept;
    std::set<std::string> stems;
    for (const auto& [name, snapshot] : known_) {
      for (const fs::path& path : results_of(snapshot.measures.time)) kept.insert(path);
      stems.insert(fs::path(profile_file_name(snapshot.measures.time)).stem().string());
    }
    std::vector<fs::path> old;
    if (fs::is_directory(run_.profiles())) {
      for (const auto& entry : fs::recursive_directory_iterator(run_.profiles())) {
        if (time_of_profile(entry.path()) && !kept.contains(entry.path())) old.push_back(entry.path());
      }
    }
    if (fs::is_directory(run_.surfaces())) {
      for (const auto& entry : fs::directory_iterator(run_.surfaces())) {
        const std::string stem = entry.path().stem().string();
        const std::size_t time = stem.rfind("_t");
        if (time != std::string::npos && !stems.contains(stem.substr(time + 1))) old.push_back(entry.path());
      }
    }
    for (const fs::path& file : old) fs::remove(file);
  }

  // The heights from which the bed's change counts, of the first snapshot that can be read; it is measured on the way.
  bool prepare() {
    for (const SeriesEntry& entry : entries_) {
      started_.insert(entry.file);
      if (done_.contains(entry.file)) {
        initial_ = initial_levels(read_particles(entry.file), settings_);
        return true;
      }
      const Outcome outcome = measure_one(entry, nullptr, &initial_);
      take_outcome(outcome);
      if (outcome.failure.empty()) return true;
    }
    return false;
  }

  void measure(const std::vector<const SeriesEntry*>& open) {
    std::size_t next = 0;
    const auto take = [&](tbb::flow_control& control) {
      while (next < open.size() && started_.contains(open[next]->file)) ++next;
      if (next == open.size()) control.stop();
      return next++;
    };
    using Token = std::shared_ptr<Outcome>;
    const auto work = [&](std::size_t n) {
      return std::make_shared<Outcome>(measure_one(*open[n], &initial_, nullptr));
    };
    const auto record = [&](const Token& outcome) { take_outcome(*outcome); };
    using enum tbb::filter_mode;
    tbb::parallel_pipeline(at_once(open), tbb::make_filter<void, std::size_t>(serial_in_order, take) &
                                              tbb::make_filter<std::size_t, Token>(parallel, work) &
                                              tbb::make_filter<Token, void>(serial_in_order, record));
  }

  [[nodiscard]] Outcome measure_one(const SeriesEntry& entry, const LevelMap* initial, LevelMap* own) const {
    Outcome outcome{&entry, {name_of_file(entry), version_of(entry.file), {}}, {}};
    try {
      outcome.measured.measures =
          measure_snapshot(read_particles(entry.file), entry.time, run_, settings_, initial, own);
    } catch (const InputError& error) {
      outcome.failure = error.what();
    }
    return outcome;
  }

  void take_outcome(const Outcome& outcome) {
    if (outcome.failure.empty()) {
      done_[outcome.entry->file] = outcome.measured;
      write_progress(progress_file(), done(), made_with_, settings_.resolved);
    } else {
      warnings_.push_back("skipped: " + outcome.failure);
    }
    progress_.show(done_.size(), outcome.entry->time);
  }

  // How many snapshots are held at a time: one for each core, as long as they take no more than a quarter of the
  // memory.
  [[nodiscard]] static std::size_t at_once(const std::vector<const SeriesEntry*>& open) {
    double largest = 1;
    for (const SeriesEntry* entry : open) {
      std::error_code failure;
      const auto size = fs::file_size(entry->file, failure);
      if (!failure) largest = std::max(largest, static_cast<double>(size));
    }
    constexpr double expansion = 30;  // [-] memory over file size: compressed file to arrays, grid and surfaces
    const double fits = 0.25 * available_memory() / (expansion * largest);
    const double cores = std::max(1U, std::thread::hardware_concurrency());
    return static_cast<std::size_t>(std::clamp(fits, 1.0, cores));
  }

  const RunFolder& run_;
  const MeasureSettings& settings_;
  const std::vector<SeriesEntry>& entries_;
  SnapshotProgress progress_;
  std::string made_with_;
  std::map<std::string, MeasuredSnapshot> known_;  // by earlier passes
  std::map<fs::path, MeasuredSnapshot> done_;
  std::set<fs::path> started_;  // before the others
  LevelMap initial_;
  std::vector<std::string> warnings_;
  std::size_t reused_ = 0;
};

void write_fronts(const fs::path& file, const std::vector<FrontSample>& fronts, double spacing) {
  CsvTable table({{"time", "s"}, {"front", "m"}});
  table.comments.push_back(
      fmt::format("largest x with more than {:g} m of water over the bed ({:g} of the particle spacing)",
                  least_layer * spacing, least_layer));
  for (const FrontSample& sample : fronts) table.add_row({csv_number(sample.time), csv_number(sample.front)});
  table.write(file);
}

// The series of the surfaces that are there.
void write_surface_series(const RunFolder& run, const std::vector<MeasuredSnapshot>& done,
                          const MeasureSettings& settings) {
  for (const SurfaceKind kind : surface_kinds) {
    std::vector<SeriesEntry> entries;
    for (const MeasuredSnapshot& snapshot : done) {
      const double time = snapshot.measures.time;
      const fs::path file = files_at(time, run, settings).surface(name_of(kind), ".vtp");
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

}  // namespace

ExtractionRun extract_run(const RunFolder& run, const Case& resolved, const ExtractionOptions& options) {
  const SnapshotList list = find_snapshots(run);
  const MeasureSettings settings = settings_of(resolved, options.lines, options.surfaces);
  ExtractionRun record;
  record.warnings = list.warnings;
  record.damaged = list.damaged;
  record.plane_y = settings.profile.plane_y;
  if (list.entries.empty()) {
    throw InputError(run.root.string() + ": none of its snapshots can be read (" + record.warnings.back() +
                     "); compute them again with thalweg-solver " + run.root.string());
  }

  Pass pass(run, settings, list.entries);
  pass.run();
  record.warnings.insert(record.warnings.end(), pass.warnings().begin(), pass.warnings().end());
  record.damaged = record.damaged || !pass.warnings().empty();
  record.reused = pass.reused();
  const std::vector<MeasuredSnapshot> done = pass.done();
  if (done.empty()) {
    throw InputError(run.root.string() + ": none of its snapshots can be read (" + record.warnings.back() +
                     "); compute them again with thalweg-solver " + run.root.string());
  }
  const MeasuredSnapshot& last = done.back();
  record.last_snapshot = run.root / last.file;
  record.last_time = last.measures.time;
  record.rest_criterion = last.measures.rest_criterion;
  record.info = read_particle_info(record.last_snapshot);
  const fs::path first_profile = files_at(done.front().measures.time, run, settings).profile;
  record.initial = TimedProfile{done.front().measures.time, {}, read_profile(first_profile)};

  std::vector<double> times = resolved.compare.times;
  if (times.empty()) times.push_back(list.entries.back().time);
  for (const MeasuredSnapshot& snapshot : done) {
    const double time = snapshot.measures.time;
    record.fronts.push_back({time, snapshot.measures.front});
    const bool asked =
        std::any_of(times.begin(), times.end(), [&](double wanted) { return std::abs(wanted - time) <= same_time; });
    if (!asked) continue;
    const fs::path file = run.profiles() / profile_file_name(time);
    copy_whole(files_at(time, run, settings).profile, file);
    record.written.push_back({time, file, read_profile(file)});
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
  write_measures(run, done, resolved);
  if (settings.surfaces) write_surface_series(run, done, settings);
  return record;
}

}  // namespace thalweg
