#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/extraction/gauges.hpp"
#include "common/io/ranged_particle_file.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "common/run_lock.hpp"
#include "solver/program/background_task.hpp"
#include "solver/program/run_counts.hpp"
#include "solver/program/run_table.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

/// The columns of history.csv beside the columns of every run.
struct HistoryColumns {
  bool current = false;               // velocity and drive of a driven flow
  std::vector<std::string> openings;  // names of inlets, then outlets
  bool grains = false;                // that water carries through them
  bool bed = false;                   // a bed that is a surface
};

/// Those of a case.
HistoryColumns history_columns(const Case& of);

/// Writes everything a run leaves in its folder; each file is whole at any moment, and on the disk before a later file
/// that builds on it. Particles are taken aside for a snapshot at once, and made into a file while the run goes on; the
/// next file that is written from particles waits for it. Those of several ranks are packed at once, range by range, and wait
/// in temporary files.
class RunOutput {
 public:
  /// `lock` tells when the folder is gone.
  RunOutput(RunFolder folder, const RunLock& lock, ParticleFileInfo info)
      : folder_(std::move(folder)), lock_(lock), info_(std::move(info)) {}

  /// Opens the tables and the series; a benchmark does not. `continued_at` [s]: rows and snapshots up to that time are
  /// kept; without it the folder holds no results. `gauge_heading` is the heading of gauges.csv; without one there is no
  /// such file. `columns`: those of history.csv beside those of every run.
  void open(std::optional<double> continued_at, const std::string& gauge_heading, const HistoryColumns& columns);

  void snapshot(Simulation& simulation, const RunClock& clock);
  void history(const Totals& totals, const MassLedger& ledger, const std::vector<OpeningFlux>& openings,
               const std::optional<BedReport>& bed, const StepReport& report, const RunClock& clock,
               const RunCounts& counts);
  /// Reads the case's gauges off the particles as they are; returns the row as written.
  GaugeRow gauges(Simulation& simulation, const Case& of, const RunClock& clock);
  /// Rows and snapshots up to now are on the disk before the checkpoint that continues them.
  void checkpoint(Simulation& simulation, const RunClock& clock, const std::string& case_text, const RunCounts& counts);
  void exclude(const std::vector<ExcludedParticle>& particles, const RunClock& clock);
  /// `steps_now`: those since the last restart.
  void finish(Simulation& simulation, const RunClock& clock, const RunCounts& counts, std::int64_t steps_now);

  /// Writes all particles as they are to `name` in the run folder, for looking at what went wrong; returns the path.
  std::filesystem::path write_diverged(Simulation& simulation, const RunClock& clock);

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  [[nodiscard]] bool has_snapshots() const { return !series_.empty(); }

 private:
  using FilePointer = std::unique_ptr<RangedParticleFile>;
  /// A file that waits for its end.
  struct Packed {
    FilePointer file;
    ParticleFileFrame frame;
  };
  std::optional<Packed> pack(Simulation& simulation, FileContents of, const RunClock& clock,
                             const std::function<FilePointer()>& begin) const;
  [[nodiscard]] ParticleFileInfo info_at(const RunClock& clock) const;
  /// Of all tables but excluded.csv, in any thread.
  void sync_series_tables() const;

  RunFolder folder_;
  const RunLock& lock_;
  ParticleFileInfo info_;
  std::vector<SeriesEntry> series_;
  int next_snapshot_ = 0;  // number in its name
  std::optional<double> continued_at_;
  HistoryColumns columns_;
  std::optional<RunTable> history_;   // none in a benchmark
  std::optional<RunTable> excluded_;  // none before the first particle is excluded
  std::optional<RunTable> gauges_;
  BackgroundTask writing_;
};

}  // namespace thalweg
