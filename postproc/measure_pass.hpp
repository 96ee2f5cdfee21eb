#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "postproc/measure_tables.hpp"
#include "postproc/progress.hpp"

namespace thalweg {

/// One pass over the snapshots of a run: it measures those that no earlier pass has measured, a few at a time as memory
/// and cores allow, writes their files and notes each in progress.csv. Results of an earlier pass are kept if the
/// snapshot, the case, the lines and the program are the same; all others are removed at the start.
class MeasurePass {
 public:
  /// Refers to its arguments, which must outlive it; `entries` is not empty.
  MeasurePass(const RunFolder& run, const MeasureSettings& settings, const std::vector<SeriesEntry>& entries);

  /// Throws RunError if results cannot be written. A snapshot that cannot be measured is named in warnings().
  void run();

  /// The measured snapshots, in the order of the entries.
  [[nodiscard]] std::vector<MeasuredSnapshot> done() const;
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// The heights of all columns of the first and of the last snapshot, as far as this pass has found them.
  [[nodiscard]] const std::shared_ptr<const LevelMap>& initial_levels() const { return initial_; }
  [[nodiscard]] const std::shared_ptr<const LevelMap>& last_levels() const { return last_; }
  /// Number of snapshots with results of an earlier pass.
  [[nodiscard]] std::size_t reused() const { return reused_; }

 private:
  struct Outcome {
    const SeriesEntry* entry;
    MeasuredSnapshot measured;
    LevelMap levels;
    std::string failure;  // empty: measured
  };

  [[nodiscard]] std::filesystem::path progress_file() const { return run_.profiles() / "progress.csv"; }
  [[nodiscard]] std::string name_of_file(const SeriesEntry& entry) const;
  [[nodiscard]] std::string description() const;
  [[nodiscard]] std::vector<std::filesystem::path> results_of(double time) const;
  [[nodiscard]] bool has_results(const MeasuredSnapshot& snapshot) const;
  void remove_others() const;
  bool prepare();
  void measure_all(const std::vector<const SeriesEntry*>& open);
  [[nodiscard]] Outcome measure_one(const SeriesEntry& entry, const LevelMap* initial) const;
  void take_outcome(const Outcome& outcome);

  const RunFolder& run_;
  const MeasureSettings& settings_;
  const std::vector<SeriesEntry>& entries_;
  SnapshotProgress progress_;
  std::string made_with_;
  std::map<std::string, MeasuredSnapshot> known_;  // by earlier passes
  std::map<std::filesystem::path, MeasuredSnapshot> done_;
  std::set<std::filesystem::path> started_;  // by prepare()
  std::shared_ptr<const LevelMap> initial_;
  std::shared_ptr<const LevelMap> last_;
  std::vector<std::string> warnings_;
  std::size_t reused_ = 0;
};

}  // namespace thalweg
