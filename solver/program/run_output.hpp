#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "common/extraction/gauges.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "solver/program/background_task.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

/// Time and step that a run has reached.
struct RunClock {
  double time = 0;  // [s]
  std::int64_t step = 0;
};

/// Counts of the run loop, for history and summary.
struct RunCounts {
  std::int64_t excluded = 0;
  std::int64_t viscous_iterations = 0;
  std::int64_t viscous_retries = 0;
  std::int64_t pressure_sweeps = 0;
  double wall_seconds = 0;
  double cpu_seconds = 0;
  double particle_steps = 0;  // fluid particles times steps
  std::int64_t steps = 0;     // of this run, without what came before a restart
};

/// Writes everything a run leaves in its folder; each file is whole at any moment. Particles are taken aside
/// for a snapshot at once, and made into a file while the run goes on; the next file that is written from particles
/// waits for it.
class RunOutput {
 public:
  /// `start` tells a fresh run (time 0: older results are replaced) from a continued one (rows and snapshots up to that
  /// time are kept). `gauge_heading` is the heading of gauges.csv; without one there is no such file.
  RunOutput(RunFolder folder, ParticleFileInfo info, const RunClock& start, const std::string& gauge_heading = {});

  void snapshot(Simulation& simulation, const RunClock& clock);
  void history(const Totals& totals, const MassLedger& ledger, const StepReport& report, const RunClock& clock,
               const RunCounts& counts);
  /// Reads the case's gauges off the particles as they are; returns the row as written.
  GaugeRow gauges(Simulation& simulation, const Case& of, const RunClock& clock);
  void checkpoint(Simulation& simulation, const RunClock& clock);
  void exclude(const std::vector<ExcludedParticle>& particles, const RunClock& clock);
  void finish(Simulation& simulation, const RunClock& clock, const RunCounts& counts);

  /// Writes all particles as they are to `name` in the run folder, for looking at what went wrong; returns the path.
  std::filesystem::path write_diverged(Simulation& simulation, const RunClock& clock);

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  /// Particles that a run continued here had already lost.
  [[nodiscard]] std::int64_t excluded_before() const { return excluded_before_; }

 private:
  [[nodiscard]] ParticleFileInfo info_at(const RunClock& clock) const;

  RunFolder folder_;
  ParticleFileInfo info_;
  std::vector<SeriesEntry> series_;
  std::ofstream history_;
  std::ofstream excluded_;
  std::ofstream gauges_;
  std::int64_t excluded_before_ = 0;
  BackgroundTask writing_;
};

}  // namespace thalweg
