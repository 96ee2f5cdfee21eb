#include "postproc/measure_pass.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/memory.hpp"
#include "common/version.hpp"
#include "postproc/snapshot_files.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The number of snapshots held in memory at a time: one for each core, as long as they take no more than a quarter of
// the memory.
std::size_t snapshots_at_once(const std::vector<const SeriesEntry*>& open) {
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

}  // namespace

MeasurePass::MeasurePass(const RunFolder& run, const MeasureSettings& settings, const std::vector<SeriesEntry>& entries)
    : run_(run), settings_(settings), entries_(entries), progress_(entries.size()) {
  made_with_ = description();
  for (MeasuredSnapshot& snapshot : read_progress(progress_file(), made_with_, settings.resolved)) {
    const bool there = snapshot.version == version_of(run.root / snapshot.file) && has_results(snapshot);
    if (there) known_[snapshot.file] = std::move(snapshot);
  }
  remove_others();
}

void MeasurePass::run() {
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
  if (!open.empty() && prepare()) measure_all(open);
  progress_.finish();
}

std::vector<MeasuredSnapshot> MeasurePass::done() const {
  std::vector<MeasuredSnapshot> all;
  for (const SeriesEntry& entry : entries_) {
    if (const auto found = done_.find(entry.file); found != done_.end()) all.push_back(found->second);
  }
  return all;
}

std::string MeasurePass::name_of_file(const SeriesEntry& entry) const {
  return entry.file.lexically_relative(run_.root).generic_string();
}

// All that the results depend on besides their snapshot.
std::string MeasurePass::description() const {
  std::string text = fmt::format("made by thalweg-postproc {} from the case {}, first snapshot {}; surfaces {}",
                                 version(), hash_of(settings_.resolved), version_of(entries_.front().file),
                                 settings_.surfaces ? "written" : "not written");
  for (const ProfileLine& line : settings_.lines) {
    text += fmt::format("; {} {} {}", line.name, fmt::join(line.from, " "), fmt::join(line.to, " "));
  }
  return text;
}

std::vector<fs::path> MeasurePass::results_of(double time) const {
  const SnapshotFiles files = files_at(time, run_, settings_);
  std::vector<fs::path> paths{files.profile};
  paths.insert(paths.end(), files.lines.begin(), files.lines.end());
  return paths;
}

bool MeasurePass::has_results(const MeasuredSnapshot& snapshot) const {
  const std::vector<fs::path> paths = results_of(snapshot.measures.time);
  return std::all_of(paths.begin(), paths.end(), [](const fs::path& path) { return fs::exists(path); });
}

// Removes all other results: those of an earlier pass, perhaps at other times, would look like results of this one.
void MeasurePass::remove_others() const {
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

// Finds the first snapshot that can be read and takes its heights, from which the bed's change counts. Measures it if no
// earlier pass has. False if no snapshot can be read.
bool MeasurePass::prepare() {
  for (const SeriesEntry& entry : entries_) {
    started_.insert(entry.file);
    if (done_.contains(entry.file)) {
      initial_ = std::make_shared<const LevelMap>(levels_of(read_particles(entry.file), settings_));
      return true;
    }
    Outcome outcome = measure_one(entry, nullptr);
    take_outcome(outcome);
    if (!outcome.failure.empty()) continue;
    initial_ = std::make_shared<const LevelMap>(std::move(outcome.levels));
    return true;
  }
  return false;
}

void MeasurePass::measure_all(const std::vector<const SeriesEntry*>& open) {
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& control) {
    while (next < open.size() && started_.contains(open[next]->file)) ++next;
    if (next == open.size()) control.stop();
    return next++;
  };
  using Token = std::shared_ptr<Outcome>;
  const auto work = [&](std::size_t n) { return std::make_shared<Outcome>(measure_one(*open[n], initial_.get())); };
  const auto record = [&](const Token& outcome) {
    take_outcome(*outcome);
    if (outcome->entry == &entries_.back() && outcome->failure.empty()) {
      last_ = std::make_shared<const LevelMap>(std::move(outcome->levels));
    }
  };
  using enum tbb::filter_mode;
  tbb::parallel_pipeline(snapshots_at_once(open), tbb::make_filter<void, std::size_t>(serial_in_order, take) &
                                                      tbb::make_filter<std::size_t, Token>(parallel, work) &
                                                      tbb::make_filter<Token, void>(serial_in_order, record));
}

MeasurePass::Outcome MeasurePass::measure_one(const SeriesEntry& entry, const LevelMap* initial) const {
  Outcome outcome{&entry, {name_of_file(entry), version_of(entry.file), {}}, {}, {}};
  try {
    SnapshotResults results = measure(read_particles(entry.file), entry.time, settings_, initial);
    write(results, run_, settings_);
    outcome.measured.measures = std::move(results.measures);
    outcome.measured.profiles = std::make_shared<SnapshotProfiles>(std::move(results.profiles));
    outcome.levels = std::move(results.levels);
  } catch (const InputError& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

void MeasurePass::take_outcome(const Outcome& outcome) {
  if (outcome.failure.empty()) {
    done_[outcome.entry->file] = outcome.measured;
    write_progress(progress_file(), done(), made_with_, settings_.resolved);
  } else {
    warnings_.push_back("skipped: " + outcome.failure);
  }
  progress_.show(done_.size(), outcome.entry->time);
}

}  // namespace thalweg
