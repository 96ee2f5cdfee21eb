#include "solver/program/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>

#include "case/reader/case_file.hpp"
#include "common/io/particle_file.hpp"
#include "common/particle_checks.hpp"
#include "common/units.hpp"
#include "solver/program/announce.hpp"
#include "solver/program/diagnosis.hpp"
#include "solver/program/progress.hpp"
#include "solver/program/run_output.hpp"
#include "solver/program/schedule.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

std::atomic<int> caught_signal{0};

void catch_signal(int signal) { caught_signal = signal; }

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double cpu_seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Case read_resolved_case(const RunOptions& options) {
  const RunFolder folder{options.folder};
  if (!std::filesystem::exists(folder.resolved_case())) {
    throw InputError(folder.resolved_case().string() +
                     ": not there; fill the scene first: thalweg gencase CASE --out " + options.folder.string());
  }
  Case c = read_case(folder.resolved_case(), options.overrides);
  if (!options.until.empty()) {
    try {
      c.output.end = parse_quantity(options.until, "s");
    } catch (const std::invalid_argument& e) {
      throw InputError("--until " + options.until + ": " + e.what());
    }
  }
  return c;
}

ParticleSet read_start(const RunOptions& options, const Case& c) {
  const auto file = options.restart.empty() ? RunFolder{options.folder}.particles() : options.restart;
  ParticleSet particles = read_particles(file);
  check_start(particles, file, c.info.dimension, c.numerics.spacing);
  const std::size_t n = particles.size();
  if (n == 0) throw InputError(file.string() + ": holds no particles; fill the scene again with gencase");
  if (particles.density.size() != n || particles.mass.size() != n) {
    throw InputError(file.string() + ": arrays Density and Mass are needed to start; write them, or fill with gencase");
  }
  if (particles.info.dimension != c.info.dimension) {
    throw InputError(fmt::format("{}: made for {} dimensions, the case has {}; fill the scene again with gencase",
                                 file.string(), particles.info.dimension, c.info.dimension));
  }
  if (std::abs(particles.info.spacing - c.numerics.spacing) > 1e-9 * c.numerics.spacing) {
    throw InputError(fmt::format("{}: filled with a spacing of {}, the case says {}; fill the scene again with gencase",
                                 file.string(), format_quantity(particles.info.spacing, "m"),
                                 format_quantity(c.numerics.spacing, "m")));
  }
  return particles;
}

/// The run: steps, and the files that are due between them.
class Run {
 public:
  Run(const Case& c, const ParticleSet& start, const RunOptions& options)
      : case_(c),
        clock_{start.info.time, start.info.step},
        simulation_(
            start_simulation(c, start, {options.backend, options.instruction_set, options.threads, options.profile})),
        output_({options.folder}, info(start), clock_, c.gauges.empty() ? std::string() : gauge_heading_line(c)),
        snapshot_times_(snapshot_times(c)),
        gauge_interval_(c.output.gauge_interval > 0 ? c.output.gauge_interval : c.output.end / 1000),
        history_interval_(c.output.history_interval > 0 ? c.output.history_interval : c.output.end / 100),
        progress_(c.output.end, clock_.time) {
    const SimulationFacts facts = simulation_->facts();
    spdlog::info("{}: {} particles, {} of them fluid; {}", c.info.name, facts.particles, facts.fluid_particles,
                 facts.device);
    next_gauges_ = gauge_time_after(clock_.time);
    counts_.excluded = output_.excluded_before();
    initial_fluid_ = facts.fluid_particles + counts_.excluded;
    announce_choices(c);
    warn_of_fast_walls(c, start);
  }

  /// Takes so many steps as fast as they go, and writes no files.
  Exit benchmark(std::int64_t steps) {
    start_clocks();
    while (counts_.steps < steps && caught_signal == 0) {
      const StepReport report = simulation_->advance(case_.output.end - clock_.time);
      if (report.diverged) fail(report);
      count(report);
      counts_.excluded += static_cast<std::int64_t>(report.excluded.size());
    }
    finish();
    return Exit::done;
  }

  Exit to_the_end() {
    start_clocks();
    last_checkpoint_ = wall_start_;
    std::size_t next = 0;
    while (next < snapshot_times_.size() && snapshot_times_[next] <= clock_.time + time_resolution()) ++next;
    if (clock_.step == 0) {
      write_snapshot();
      if (!case_.gauges.empty()) read_gauges_now();
    }
    while (next < snapshot_times_.size()) {
      step(snapshot_times_[next] - clock_.time);
      if (snapshot_times_[next] - clock_.time <= time_resolution()) {
        clock_.time = snapshot_times_[next];  // landed on: without the rounding of the sum of steps
        write_snapshot();
        ++next;
      }
      if (caught_signal != 0) return stop_early();
    }
    const auto last = simulation_->take_excluded();
    if (!last.empty()) exclude(last);
    write_checkpoint();
    finish();
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

  ParticleFileInfo info(const ParticleSet& start) const {
    ParticleFileInfo i = start.info;
    i.case_name = case_.info.name;
    i.code_version = THALWEG_VERSION;
    i.case_hash = hash_of(case_);
    i.dimension = case_.info.dimension;
    i.spacing = case_.numerics.spacing;
    i.smoothing_length = case_.smoothing_length();
    return i;
  }

  void step(double longest) {
    simulation_->set_time(clock_.time);
    const StepReport report = simulation_->advance(longest);
    if (!report.excluded.empty()) exclude(report.excluded);
    if (report.diverged) fail(report);
    count(report);
    warn_of_fallbacks(report);
    simulation_->timing().time("output", [&] {
      if (clock_.step == 1 || clock_.time >= next_history_) {
        output_.history(simulation_->totals(), simulation_->ledger(), report, clock_, counts_);
        next_history_ = (std::floor(clock_.time / history_interval_) + 1) * history_interval_;
      }
      if (!case_.gauges.empty() && clock_.time >= next_gauges_ - gauge_rounding * gauge_interval_) {
        read_gauges_now();
        next_gauges_ = gauge_time_after(clock_.time);
      }
      if (seconds_now() - last_checkpoint_ > case_.output.checkpoint_interval) write_checkpoint();
      progress_.show(clock_.time, clock_.step, report.dt, limiter_name(report.limiter), counts_.particle_steps);
    });
  }

  void count(const StepReport& report) {
    clock_.time += report.dt;
    ++clock_.step;
    ++counts_.steps;
    counts_.particle_steps += static_cast<double>(initial_fluid_ - counts_.excluded);
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

  void write_snapshot() {
    simulation_->timing().time("output", [&] { output_.snapshot(*simulation_, clock_); });
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
    output_.checkpoint(*simulation_, clock_);
    last_checkpoint_ = seconds_now();
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
                      "see {} for where, then widen the domain or close the wall there",
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
    count_seconds();
    output_.finish(*simulation_, clock_, counts_);
    spdlog::info("t = {:.6g} s after {} steps, {:.1f} s, {:.3g} M particle-steps/s{}", clock_.time, clock_.step,
                 counts_.wall_seconds, counts_.particle_steps / std::max(1e-9, counts_.wall_seconds) * 1e-6,
                 counts_.excluded > 0 ? fmt::format(", {} particles excluded", counts_.excluded) : "");
  }

  void start_clocks() {
    wall_start_ = seconds_now();
    cpu_start_ = cpu_seconds_now();
  }

  void count_seconds() {
    counts_.wall_seconds = seconds_now() - wall_start_;
    counts_.cpu_seconds = cpu_seconds_now() - cpu_start_;
  }

  Exit stop_early() {
    const auto last = simulation_->take_excluded();
    if (!last.empty()) exclude(last);
    write_checkpoint();
    finish();
    const int signal = caught_signal;
    spdlog::warn("stopped by {}; continue with: thalweg solver {} --restart {}",
                 signal == SIGINT ? "Ctrl-C" : "SIGTERM", output_.folder().root.string(),
                 output_.folder().checkpoint().string());
    return signal == SIGINT ? Exit::interrupted : Exit::terminated;
  }

  Case case_;
  RunClock clock_;
  std::unique_ptr<Simulation> simulation_;
  RunOutput output_;
  std::vector<double> snapshot_times_;
  double gauge_interval_;
  double history_interval_;
  Progress progress_;
  RunCounts counts_;
  std::int64_t initial_fluid_ = 0;
  bool told_of_cap_ = false;
  bool told_of_gauges_ = false;
  bool told_of_sweeps_ = false;
  double next_history_ = 0;
  double next_gauges_ = 0;
  double wall_start_ = 0;
  double cpu_start_ = 0;
  double last_checkpoint_ = 0;
};

}  // namespace

Exit run_solver(const RunOptions& options) {
  const Case c = read_resolved_case(options);
  const ParticleSet start = read_start(options, c);
  if (start.info.time >= c.output.end) {
    throw InputError(
        fmt::format("the checkpoint is at t = {:.6g} s and the run ends at {:.6g} s; give a later end with --until",
                    start.info.time, c.output.end));
  }
  std::signal(SIGINT, catch_signal);
  std::signal(SIGTERM, catch_signal);
  Run run(c, start, options);
  return options.benchmark > 0 ? run.benchmark(options.benchmark) : run.to_the_end();
}

}  // namespace thalweg
