#include "solver/program/run_output.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cstdlib>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

constexpr const char* history_header =
    "time [s],step [-],dt [s],dt_limiter,kinetic_energy [J],potential_energy [J],internal_energy [J],water_mass [kg],"
    "sediment_mass [kg],excluded [-],max_speed [m/s],viscous_iterations [-],viscous_residual [-],viscous_retries [-],"
    "viscosity_capped [-],pressure_sweeps [-],resting [-],bed_load [-],suspended [-],mass_in [kg],mass_out [kg],"
    "mass_lost [kg]";
constexpr const char* excluded_header =
    "time [s],id [-],type [-],x [m],y [m],z [m],velocity_x [m/s],velocity_y [m/s],velocity_z [m/s]";

/// Rewrites a table of ours whose first column is time, with the rows up to `keep_until` of what stands there under the
/// same heading, and opens it for more; `rows` is how many.
std::ofstream reopen_table(const std::filesystem::path& file, const std::string& header, double keep_until,
                           std::int64_t& rows) {
  std::vector<std::string> kept;
  if (keep_until > 0) {
    std::ifstream old(file);
    std::string line;
    std::getline(old, line);
    const bool same = line == header;
    while (same && std::getline(old, line)) {
      char* end = nullptr;
      const double time = std::strtod(line.c_str(), &end);
      if (end != line.c_str() && time <= keep_until) kept.push_back(line);
    }
  }
  write_whole_text(file, [&](std::ostream& to) {
    to << header << '\n';
    for (const std::string& row : kept) to << row << '\n';
  });
  rows = static_cast<std::int64_t>(kept.size());
  std::ofstream table(file, std::ios::app);
  if (!table) throw RunError(file.string() + ": cannot be written; check permissions and free space");
  return table;
}

void flush_row(std::ofstream& table, const std::filesystem::path& file) {
  table.flush();
  if (!table) throw RunError(file.string() + ": cannot be written any more; is the disk full?");
}

}  // namespace

RunOutput::RunOutput(RunFolder folder, ParticleFileInfo info, const RunClock& start, const std::string& gauge_heading)
    : folder_(std::move(folder)), info_(std::move(info)) {
  std::error_code ignored;
  std::filesystem::create_directories(folder_.snapshots(), ignored);
  if (start.time > 0 && std::filesystem::exists(folder_.snapshot_series())) {
    series_ = read_series(folder_.snapshot_series());
    std::erase_if(series_, [&](const SeriesEntry& e) { return e.time > start.time; });
  } else {
    std::filesystem::remove(folder_.snapshot_series(), ignored);
    for (const auto& old : std::filesystem::directory_iterator(folder_.snapshots(), ignored)) {
      if (old.path().extension() == ".vtp") std::filesystem::remove(old.path(), ignored);
    }
  }
  std::int64_t history_rows = 0;
  history_ = reopen_table(folder_.history(), history_header, start.time, history_rows);
  excluded_ = reopen_table(folder_.excluded(), excluded_header, start.time, excluded_before_);
  if (gauge_heading.empty()) {
    std::filesystem::remove(folder_.gauges(), ignored);
  } else {
    std::int64_t gauge_rows = 0;
    gauges_ = reopen_table(folder_.gauges(), gauge_heading, start.time, gauge_rows);
  }
}

ParticleFileInfo RunOutput::info_at(const RunClock& clock) const {
  ParticleFileInfo info = info_;
  info.time = clock.time;
  info.step = clock.step;
  return info;
}

void RunOutput::snapshot(Simulation& simulation, const RunClock& clock) {
  writing_.wait();
  const std::filesystem::path name = folder_.snapshots().filename() / fmt::format("s{:05}.vtp", series_.size());
  series_.push_back({clock.time, name});
  writing_.start([take = simulation.begin_snapshot(), info = info_at(clock), file = folder_.root / name,
                  all = folder_.snapshot_series(), series = series_] {
    ParticleSet particles = take();
    particles.info = info;
    write_particles(file, particles, PositionPrecision::single_precision);
    write_series(all, series);
  });
}

void RunOutput::history(const Totals& t, const MassLedger& ledger, const StepReport& report, const RunClock& clock,
                        const RunCounts& counts) {
  const double of_sediment = static_cast<double>(std::max<std::int64_t>(1, t.sediment));
  const auto share = [&](std::int64_t n) { return static_cast<double>(n) / of_sediment; };
  fmt::print(history_, "{:.9g},{},{:.6g},{},{:.9g},{:.9g},{:.9g},{:.12g},{:.12g},{},{:.6g},{},{:.3g},{},{},{},",
             clock.time, clock.step, report.dt, limiter_name(report.limiter), t.kinetic_energy, t.potential_energy,
             t.internal_energy, t.water_mass, t.sediment_mass, counts.excluded, report.largest_speed,
             report.viscous.iterations, report.viscous.residual, counts.viscous_retries, report.viscous.capped,
             report.pressure_sweeps);
  fmt::print(history_, "{:.4g},{:.4g},{:.4g},{:.9g},{:.9g},{:.9g}\n", share(t.resting), share(t.bed_load),
             share(t.suspended), ledger.in, ledger.out, ledger.lost);
  flush_row(history_, folder_.history());
}

GaugeRow RunOutput::gauges(Simulation& simulation, const Case& of, const RunClock& clock) {
  ParticleSet particles = simulation.snapshot_within(gauge_regions(of, info_));
  particles.info = info_at(clock);
  GaugeRow row = read_gauges(of, particles);
  gauges_ << gauge_line(clock.time, row) << '\n';
  flush_row(gauges_, folder_.gauges());
  return row;
}

void RunOutput::checkpoint(Simulation& simulation, const RunClock& clock) {
  ParticleSet particles = simulation.full_state();
  writing_.wait();
  particles.info = info_at(clock);
  write_particles(folder_.checkpoint(), particles, PositionPrecision::double_precision);
}

void RunOutput::exclude(const std::vector<ExcludedParticle>& particles, const RunClock& clock) {
  for (const ExcludedParticle& p : particles) {
    fmt::print(excluded_, "{:.9g},{},{},{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}\n", clock.time, p.id, p.type,
               p.position.x[0], p.position.x[1], p.position.x[2], p.velocity[0], p.velocity[1], p.velocity[2]);
  }
  if (!particles.empty()) flush_row(excluded_, folder_.excluded());
}

std::filesystem::path RunOutput::write_diverged(Simulation& simulation, const RunClock& clock) {
  ParticleSet particles = simulation.snapshot();
  particles.info = info_at(clock);
  const auto file = folder_.root / "diverged.vtp";
  writing_.wait();
  write_particles(file, particles, PositionPrecision::single_precision);
  return file;
}

void RunOutput::finish(Simulation& simulation, const RunClock& clock, const RunCounts& counts) {
  writing_.wait();
  double total = 0;
  for (const auto& entry : simulation.timing().entries()) total += entry.seconds;
  write_whole_text(folder_.timing(), [&](std::ostream& to) {
    to << "heading,seconds [s],share [-],calls [-]\n";
    for (const auto& entry : simulation.timing().entries()) {
      fmt::print(to, "{},{:.4f},{:.4f},{}\n", entry.heading, entry.seconds, total > 0 ? entry.seconds / total : 0,
                 entry.calls);
    }
  });
  const SimulationFacts facts = simulation.facts();
  write_whole_text(folder_.summary(), [&](std::ostream& to) {
    const auto row = [&](const char* quantity, const auto& value, const char* unit) {
      fmt::print(to, "{},{},{}\n", quantity, value, unit);
    };
    const double steps = std::max(1.0, static_cast<double>(counts.steps));
    to << "quantity,value,unit\n";
    row("case", info_.case_name, "");
    row("code_version", info_.code_version, "");
    row("case_hash", info_.case_hash, "");
    row("device", '"' + facts.device + '"', "");
    row("dimension", info_.dimension, "-");
    row("spacing", info_.spacing, "m");
    row("particles", facts.particles, "-");
    row("fluid_particles", facts.fluid_particles, "-");
    row("excluded", counts.excluded, "-");
    row("physical_time", clock.time, "s");
    row("steps", clock.step, "-");
    row("steps_since_restart", counts.steps, "-");
    row("wall_seconds", fmt::format("{:.3f}", counts.wall_seconds), "s");
    row("cpu_seconds", fmt::format("{:.3f}", counts.cpu_seconds), "s");
    row("particle_steps_per_second", fmt::format("{:.0f}", counts.particle_steps / std::max(1e-9, counts.wall_seconds)),
        "1/s");
    row("viscous_iterations_per_step", fmt::format("{:.2f}", static_cast<double>(counts.viscous_iterations) / steps),
        "-");
    row("viscous_retries", counts.viscous_retries, "-");
    row("pressure_sweeps_per_step", fmt::format("{:.2f}", static_cast<double>(counts.pressure_sweeps) / steps), "-");
    row("list_rebuilds", facts.list_rebuilds, "-");
    row("neighbours_mean", fmt::format("{:.1f}", facts.neighbours_mean), "-");
    row("list_entries_per_particle", fmt::format("{:.1f}", facts.list_entries_per_particle), "-");
    row("bytes_per_particle", fmt::format("{:.0f}", facts.bytes_per_particle), "B");
  });
}

}  // namespace thalweg
