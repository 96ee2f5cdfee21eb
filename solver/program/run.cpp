#include "solver/program/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "case/models/suspended_load.hpp"
#include "case/reader/case_file.hpp"
#include "case/reader/differences.hpp"
#include "common/io/run_results.hpp"
#include "common/run_lock.hpp"
#include "common/signals.hpp"
#include "common/version.hpp"
#include "common/warnings.hpp"
#include "common/whole_file.hpp"
#include "solver/program/announce.hpp"
#include "solver/program/balance.hpp"
#include "solver/program/diagnosis.hpp"
#include "solver/program/disk.hpp"
#include "solver/program/follow_run.hpp"
#include "solver/program/progress.hpp"
#include "solver/program/read_run.hpp"
#include "solver/program/run_output.hpp"
#include "solver/program/schedule.hpp"
#include "solver/program/stopwatch.hpp"
#include "solver/program/warning_sink.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

/// 128 and the signal, as a shell says of a program that a signal has ended.
Exit status_of(int signal) { return static_cast<Exit>(128 + signal); }

/// The run: steps, and the files that are due between them.
class Run {
 public:
  /// Keeps none of the particles that it starts from.
  Run(RunStart from, const RunOptions& options, const RunLock& lock)
      : case_(from.scene),
        case_text_(case_text(from.scene)),
        clock_{from.particles.info.time, from.particles.info.step},
        simulation_(start(from, options)),
        output_({options.folder}, lock, info(from.particles)),
        progress_({case_.output.end, case_.surface_bed.end}, {clock_.time, simulation_->bed_time()}),
        counts_(from.counts),
        bed_schedule_(case_) {
    bed_schedule_.begin(simulation_->bed_time());
    const SimulationFacts facts = simulation_->facts();
    spdlog::info("{}: {} particles, {} of them fluid; {}", case_.info.name, facts.particles, facts.fluid_particles,
                 facts.device);
    initial_fluid_ = facts.fluid_particles + counts_.excluded;
    announce_choices(case_);
    warn_of_fast_walls(case_, from.wall_speed);
  }

  /// Takes so many steps as fast as they go, and writes no files.
  Exit benchmark(std::int64_t steps) {
    since_start_ = {};
    while (steps_now_ < steps && stop_signal() == 0) {
      const StepReport report = simulation_->advance(case_.output.end - clock_.time);
      if (report.diverged) fail(report);
      count(report);
      counts_.excluded += static_cast<std::int64_t>(report.excluded.size());
    }
    finish();
    return Exit::done;
  }

  Exit to_the_end(bool continued) {
    schedule_output();
    output_.open(continued ? std::make_optional(clock_.time) : std::nullopt,
                 case_.gauges.empty() ? std::string() : gauge_heading_line(case_), history_columns(case_));
    since_start_ = {};
    since_checkpoint_ = {};
    if (clock_.step == 0 && !output_.has_snapshots()) {
      write_snapshot();
      if (!case_.gauges.empty()) read_gauges_now();
    }
    const std::vector<double> times = snapshot_times(case_);
    std::size_t next = 0;
    while (next < times.size() && times[next] <= clock_.time + time_resolution()) ++next;
    while (next < times.size() && !bed_schedule_.is_at_end(simulation_->bed_time())) {
      const bool bed_is_due = step(times[next] - clock_.time);
      const bool is_due = times[next] - clock_.time <= time_resolution();
      if (is_due) clock_.time = times[next++];  // landed on: without the rounding of the sum of steps
      if (is_due || bed_is_due) write_snapshot();
      // After the snapshot of the same step, which a continued run takes as written.
      if (take_write_request() || since_checkpoint_.wall() > case_.output.checkpoint_interval) write_checkpoint();
      if (stop_signal() != 0) return stop_early();
    }
    const auto last = simulation_->take_excluded();
    if (!last.empty()) exclude(last);
    write_checkpoint();
    finish();
    warn_of_slow_bed();
    return Exit::done;
  }

 private:
  [[nodiscard]] double time_resolution() const { return 1e-9 * case_.output.end; }

  /// A time that misses a multiple of the interval by the rounding of a sum of steps counts as that multiple, so that a
  /// continued run reads its gauges when the run without a break does.
  static constexpr double gauge_rounding = 1e-6;
  [[nodiscard]] double gauge_time_after(double time) const {
    return (std::floor(time / gauge_interval_ + gauge_rounding) + 1) * gauge_interval_;
  }

  void schedule_output() {
    const Output& output = case_.output;
    gauge_interval_ = output.gauge_interval > 0 ? output.gauge_interval : output.end / 1000;
    history_interval_ = output.history_interval > 0 ? output.history_interval : output.end / 100;
    next_gauges_ = gauge_time_after(clock_.time);
  }

  ParticleFileInfo info(const ParticleSet& start) const {
    ParticleFileInfo i = start.info;
    i.case_name = case_.info.name;
    i.code_version = version();
    i.case_hash = hash_of(case_);
    i.dimension = case_.info.dimension;
    i.spacing = case_.numerics.spacing;
    i.smoothing_length = case_.smoothing_length();
    return i;
  }

  /// Returns true if a snapshot is due at the bed's time. history.csv then tells that time.
  bool step(double longest) {
    simulation_->set_time(clock_.time);
    const StepReport report = simulation_->advance(longest);
    if (!report.excluded.empty()) exclude(report.excluded);
    if (report.diverged) fail(report);
    count(report);
    warn_of_fallbacks(report);
    const bool bed_is_due = bed_schedule_.passes(simulation_->bed_time());
    simulation_->timing().time("output", [&] {
      if (clock_.step == 1 || clock_.time >= next_history_ || bed_is_due) {
        write_history(report);
        next_history_ = (std::floor(clock_.time / history_interval_) + 1) * history_interval_;
      }
      if (!case_.gauges.empty() && clock_.time >= next_gauges_ - gauge_rounding * gauge_interval_) {
        read_gauges_now();
        next_gauges_ = gauge_time_after(clock_.time);
      }
      progress_.show({clock_.time, simulation_->bed_time()}, clock_.step, report.dt, limiter_name(report.limiter),
                     counts_.particle_steps);
    });
    return bed_is_due;
  }

  void write_history(const StepReport& report) {
    const Totals totals = simulation_->totals();
    const MassLedger ledger = simulation_->ledger();
    const std::vector<OpeningFlux> openings = simulation_->openings();
    output_.history(totals, ledger, openings, simulation_->bed(), report, clock_, counts_);
    try {
      balance_.check(totals, ledger, openings, clock_, models::SuspendedLoadOfWater::is_on(case_));
    } catch (const RunError&) {
      write_checkpoint();
      finish();
      throw;
    }
  }

  void count(const StepReport& report) {
    clock_.time += report.dt;
    ++clock_.step;
    ++counts_.steps;
    ++steps_now_;
    counts_.particle_steps += static_cast<double>(report.fluid);
    counts_.viscous_iterations += report.viscous.iterations;
    counts_.pressure_sweeps += report.pressure_sweeps;
  }

  /// Warns the first time that a step needed more than usual; history.csv counts all of them.
  void warn_of_fallbacks(const StepReport& report) {
    if (report.viscous.retries > 0 && counts_.viscous_retries == 0) {
      spdlog::warn(
          "the implicit viscosity did not converge in {} iterations at t = {:.4g} s; solved again {}, residual {:.2g}. "
          "history.csv counts such solves in viscous_retries",
          case_.numerics.viscous_iterations, clock_.time,
          report.viscous.retries == 1 ? std::string("without a guess")
                                      : fmt::format("with a step of {:.3g} s", report.dt),
          report.viscous.residual);
    }
    counts_.viscous_retries += report.viscous.retries;
    if (report.viscous.capped > 0 && !told_of_cap_) {
      spdlog::warn("the viscosity of {} particles is cut to what a step of {:.3g} s can take: the bed creeps; {}",
                   report.viscous.capped, report.dt, "history.csv counts them in viscosity_capped");
      told_of_cap_ = true;
    }
    if (!report.pressure_settled && !told_of_sweeps_) {
      spdlog::warn(
          "the effective pressure did not settle in {} sweeps at t = {:.4g} s; the next step goes on from there",
          report.pressure_sweeps, clock_.time);
      told_of_sweeps_ = true;
    }
  }

  /// A bed that is a surface may change so fast that the windows of its stress take longer.
  void warn_of_slow_bed() const {
    const auto bed = simulation_->bed();
    const double water_time = clock_.time - case_.surface_bed.spin_up;
    if (!bed || bed->steps == 0 || bed->time >= 0.9 * water_time) return;
    spdlog::warn(
        "the bed's time came to {:.3g} s while the water's ran {:.3g} s: the bed changes faster than its stress can be "
        "averaged; for scour within seconds write sediment = \"three-state\"",
        bed->time, water_time);
  }

  void write_snapshot() {
    simulation_->timing().time("output", [&] { output_.snapshot(*simulation_, clock_); });
    spdlog::debug("snapshot of t = {:.6g} s, step {}", clock_.time, clock_.step);
  }

  /// Gauges are read on the host, whatever device computes the particles around them.
  void read_gauges_now() {
    const GaugeRow row = output_.gauges(*simulation_, case_, clock_);
    if (row.notes.empty() || told_of_gauges_) return;
    spdlog::warn("gauges without a value at t = {:.4g} s: {}; their cells in {} are empty, and say so in the note",
                 clock_.time, fmt::join(row.notes, "; "), output_.folder().gauges().string());
    told_of_gauges_ = true;
  }

  void write_checkpoint() {
    simulation_->timing().time("output", [&] { output_.checkpoint(*simulation_, clock_, case_text_, counts_now()); });
    spdlog::debug("checkpoint at t = {:.6g} s, step {}", clock_.time, clock_.step);
    since_checkpoint_ = {};
  }

  void exclude(const std::vector<ExcludedParticle>& particles) {
    if (counts_.excluded == 0) {
      spdlog::warn("first particle out of the domain at t = {:.4g} s, at x = {:.4g} m, z = {:.4g} m; see {}",
                   clock_.time, particles.front().position.x[0], particles.front().position.x[2],
                   output_.folder().excluded().string());
    }
    output_.exclude(particles, clock_);
    counts_.excluded += static_cast<std::int64_t>(particles.size());
    const double limit = case_.numerics.excluded_limit * static_cast<double>(initial_fluid_);
    if (static_cast<double>(counts_.excluded) > limit) {
      write_checkpoint();
      finish();
      throw RunError(
          fmt::format("{} of {} fluid particles have left the domain by t = {:.4g} s, more than "
                      "numerics.excluded_limit ({:g}) allows; "
                      "see {} for where, then widen the domain, close the wall, or let it leave by an [[outlet]] there",
                      counts_.excluded, initial_fluid_, clock_.time, case_.numerics.excluded_limit,
                      output_.folder().excluded().string()));
    }
  }

  [[noreturn]] void fail(const StepReport& report) {
    const auto file = output_.write_diverged(*simulation_, clock_);
    finish();
    throw RunError(diagnose(report, simulation_->snapshot(), case_, clock_) +
                   "; particles as they are: " + file.string());
  }

  void finish() {
    progress_.clear();
    const RunCounts counts = counts_now();
    output_.finish(*simulation_, clock_, counts, steps_now_);
    spdlog::info("t = {:.6g} s after {} steps, {:.1f} s, {:.3g} M particle-steps/s{}", clock_.time, clock_.step,
                 counts.wall_seconds, counts.particle_steps / std::max(1e-9, counts.wall_seconds) * 1e-6,
                 counts_.excluded > 0 ? fmt::format(", {} particles excluded", counts_.excluded) : "");
  }

  /// The counts with the seconds since the start of this part of the run.
  [[nodiscard]] RunCounts counts_now() const {
    RunCounts counts = counts_;
    counts.wall_seconds += since_start_.wall();
    counts.cpu_seconds += since_start_.cpu() + simulation_->cpu_seconds_elsewhere();
    return counts;
  }

  Exit stop_early() {
    const auto last = simulation_->take_excluded();
    if (!last.empty()) exclude(last);
    write_checkpoint();
    finish();
    const int signal = stop_signal();
    spdlog::warn("stopped by {}; continue with: thalweg solver {} --restart latest", signal_name(signal),
                 output_.folder().root.string());
    return status_of(signal);
  }

  Case case_;
  std::string case_text_;
  RunClock clock_;
  std::unique_ptr<Simulation> simulation_;
  RunOutput output_;
  double gauge_interval_ = 0;
  double history_interval_ = 0;
  Progress progress_;
  RunCounts counts_;
  MassBalance balance_;
  BedSchedule bed_schedule_;
  std::int64_t steps_now_ = 0;  // since the last restart
  std::int64_t initial_fluid_ = 0;
  bool told_of_cap_ = false;
  bool told_of_gauges_ = false;
  bool told_of_sweeps_ = false;
  double next_history_ = 0;
  double next_gauges_ = 0;
  Stopwatch since_start_;
  Stopwatch since_checkpoint_;
};

}  // namespace

Exit run_solver(const RunOptions& options) {
  if (options.ranks != nullptr && options.ranks->rank() > 0) return follow_run(options);
  Invitation others(options.ranks);
  const RunFolder folder{options.folder};
  require_filled(folder);
  const RunLock lock(options.folder, "thalweg-solver");
  if (options.benchmark == 0) keep_warnings(folder);
  RunStart start = read_run(options);
  const bool fresh = options.benchmark == 0 && !start.continued;
  if (fresh && !options.force && options.restart.empty()) {
    refuse_to_replace(folder, "continue it with --restart latest, or replace it with --force");
  }
  if (fresh) WarningFile(folder, "solver").clear();
  if (options.benchmark == 0)
    check_disk(start.scene, folder, {start.particles.info.time, start.size(), options.ranks != nullptr});
  others.send();
  const bool continued = start.continued;
  Run run(std::move(start), options, lock);
  if (options.benchmark > 0) return run.benchmark(options.benchmark);
  if (stop_signal() != 0) {
    spdlog::warn("stopped by {} before the first step; {} is as it was", signal_name(stop_signal()),
                 options.folder.string());
    return status_of(stop_signal());
  }
  remove_dead_parts(options.folder);
  if (fresh) remove_results(folder);
  try {
    return run.to_the_end(continued);
  } catch (const RunError&) {
    lock.require_folder();  // a folder that has gone is the reason why a file in it cannot be written
    throw;
  }
}

}  // namespace thalweg
