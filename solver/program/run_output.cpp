#include "solver/program/run_output.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/run_results.hpp"
#include "common/whole_file.hpp"
#include "solver/program/checkpoint_file.hpp"

namespace thalweg {
namespace {

constexpr const char* history_header =
    "time [s],step [-],dt [s],dt_limiter,kinetic_energy [J],potential_energy [J],internal_energy [J],water_mass [kg],"
    "sediment_mass [kg],excluded [-],max_speed [m/s],viscous_iterations [-],viscous_residual [-],viscous_retries [-],"
    "viscosity_capped [-],pressure_sweeps [-],resting [-],bed_load [-],suspended [-],mass_in [kg],mass_out [kg],"
    "mass_lost [kg],grain_mass [kg],suspended_mass [kg]";
constexpr const char* history_of_current = ",bulk_velocity [m/s],drive [m/s^2]";
/// The columns of an opening, after its name.
constexpr const char* history_of_opening = ",{0}_water [kg],{0}_sediment [kg],{0}_level [m]";
constexpr const char* history_of_grains = ",{0}_grains [kg]";
/// Of a bed that is a surface.
constexpr const char* history_of_bed =
    ",bed_time [s],bed_factor [-],bed_grains [m^3],bed_fed [m^3],bed_left [m^3],bed_lifted [m^3],bed_lowest [m],"
    "bed_highest [m],bed_scour [m],bed_scour_x [m],bed_scour_y [m],bed_steps [-],bed_unsettled [-]";
constexpr const char* excluded_header =
    "time [s],id [-],type [-],x [m],y [m],z [m],velocity_x [m/s],velocity_y [m/s],velocity_z [m/s]";

std::string history_heading(const HistoryColumns& columns) {
  std::string heading = history_header;
  if (columns.current) heading += history_of_current;
  for (const std::string& name : columns.openings) {
    heading += fmt::format(fmt::runtime(history_of_opening), name);
    if (columns.grains) heading += fmt::format(fmt::runtime(history_of_grains), name);
  }
  if (columns.bed) heading += history_of_bed;
  return heading;
}

std::unique_ptr<RangedParticleFile> ranged_file(const std::filesystem::path& file) {
  return std::make_unique<RangedParticleFile>(file, WholeFile{.make_folders = false});
}

/// The number in the name of a snapshot, "s00012.vtp"; -1 for other names.
int number_of_snapshot(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  int number = -1;
  if (stem.size() > 1) std::from_chars(stem.data() + 1, stem.data() + stem.size(), number);
  return number;
}

}  // namespace

HistoryColumns history_columns(const Case& of) {
  HistoryColumns columns;
  columns.current = of.flow.drive != Drive::off;
  columns.grains = models::SuspendedLoadOfWater::is_on(of);
  columns.bed = models::SurfaceBedOfCase::is_on(of);
  for (const Inlet& inlet : of.inlets) columns.openings.push_back(inlet.name);
  for (const Outlet& outlet : of.outlets) columns.openings.push_back(outlet.name);
  return columns;
}

void RunOutput::open(std::optional<double> continued_at, const std::string& gauge_heading,
                     const HistoryColumns& columns) {
  continued_at_ = continued_at;
  columns_ = columns;
  std::error_code failure;
  std::filesystem::create_directories(folder_.snapshots(), failure);
  if (failure) throw RunError(folder_.snapshots().string() + ": cannot be made: " + failure.message());
  if (continued_at) {
    series_ = snapshots_until(folder_, *continued_at);
    for (const SeriesEntry& entry : series_) {
      next_snapshot_ = std::max(next_snapshot_, number_of_snapshot(entry.file) + 1);
    }
    if (!series_.empty()) write_series(folder_.snapshot_series(), series_, {.make_folders = false});
  }
  history_.emplace(folder_.history(), history_heading(columns), continued_at);
  if (!gauge_heading.empty()) gauges_.emplace(folder_.gauges(), gauge_heading, continued_at);
  if (continued_at && std::filesystem::exists(folder_.excluded())) {
    excluded_.emplace(folder_.excluded(), excluded_header, continued_at);
  }
}

void RunOutput::sync_series_tables() const {
  for (const auto* table : {&history_, &gauges_}) {
    if (*table) (*table)->sync();
  }
}

ParticleFileInfo RunOutput::info_at(const RunClock& clock) const {
  ParticleFileInfo info = info_;
  info.time = clock.time;
  info.step = clock.step;
  return info;
}

/// A file whose particles several ranks have handed over; nothing where they lie in this process.
std::optional<RunOutput::Packed> RunOutput::pack(Simulation& simulation, FileContents of, const RunClock& clock,
                                                 const std::function<FilePointer()>& begin) const {
  Packed packed;
  const auto frame = simulation.pack(of, info_.spacing, [&](const PackedRange& range) {
    if (packed.file == nullptr) packed.file = begin();
    packed.file->add(range);
  });
  if (!frame) return std::nullopt;
  if (packed.file == nullptr) packed.file = begin();  // of no particles
  packed.frame = {info_at(clock), frame->facts, {}, frame->precision};
  return packed;
}

void RunOutput::snapshot(Simulation& simulation, const RunClock& clock) {
  writing_.wait();
  const std::filesystem::path name = folder_.snapshots().filename() / fmt::format("s{:05}.vtp", next_snapshot_++);
  series_.push_back({clock.time, name});
  const auto file = folder_.root / name;
  const auto write_beside = [this, series = series_] {
    write_series(folder_.snapshot_series(), series, {.make_folders = false});
    sync_series_tables();
  };
  if (auto packed = pack(simulation, FileContents::snapshot, clock, [&] { return ranged_file(file); })) {
    writing_.start([this, packed = std::move(*packed), write_beside] {
      lock_.require_folder();
      packed.file->finish(packed.frame);
      write_beside();
    });
    return;
  }
  writing_.start([this, take = simulation.begin_snapshot(), info = info_at(clock), file, write_beside] {
    ParticleSet particles = take();
    particles.info = info;
    lock_.require_folder();
    write_particles(file, particles, PositionPrecision::single_precision, {}, {.make_folders = false});
    write_beside();
  });
}

void RunOutput::history(const Totals& t, const MassLedger& ledger, const std::vector<OpeningFlux>& openings,
                        const std::optional<BedReport>& bed, const StepReport& report, const RunClock& clock,
                        const RunCounts& counts) {
  const double of_sediment = static_cast<double>(std::max<std::int64_t>(1, t.sediment));
  const auto share = [&](std::int64_t n) { return static_cast<double>(n) / of_sediment; };
  std::string row = fmt::format(
      "{:.9g},{},{:.6g},{},{:.9g},{:.9g},{:.9g},{:.12g},{:.12g},{},{:.6g},{},{:.3g},{},{},{},", clock.time, clock.step,
      report.dt, limiter_name(report.limiter), t.kinetic_energy, t.potential_energy, t.internal_energy, t.water_mass,
      t.sediment_mass, counts.excluded, report.largest_speed, report.viscous.iterations, report.viscous.residual,
      counts.viscous_retries, report.viscous.capped, report.pressure_sweeps);
  row += fmt::format("{:.4g},{:.4g},{:.4g},{:.9g},{:.9g},{:.9g},{:.12g},{:.9g}", share(t.resting), share(t.bed_load),
                     share(t.suspended), ledger.in, ledger.out, ledger.lost, t.grain_mass, t.suspended_mass);
  if (columns_.current) row += fmt::format(",{:.9g},{:.9g}", t.bulk_velocity, t.drive);
  for (const OpeningFlux& opening : openings) {
    row += fmt::format(",{:.9g},{:.9g},", opening.water, opening.sediment);
    if (!std::isnan(opening.level)) row += fmt::format("{:.6g}", opening.level);
    if (columns_.grains) row += fmt::format(",{:.9g}", opening.grains);
  }
  if (bed) {
    row += fmt::format(",{:.9g},{:.6g},{:.12g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{},{}",
                       bed->time, bed->factor, bed->grains, bed->fed, bed->left, bed->lifted, bed->lowest, bed->highest,
                       bed->scour, bed->scour_at[0], bed->scour_at[1], bed->steps, bed->unsettled);
  }
  lock_.require_folder();
  history_->add(row);
}

GaugeRow RunOutput::gauges(Simulation& simulation, const Case& of, const RunClock& clock) {
  ParticleSet particles = simulation.snapshot_within(gauge_regions(of, info_));
  particles.info = info_at(clock);
  GaugeRow row = read_gauges(of, particles);
  gauges_->add(gauge_line(clock.time, row));
  return row;
}

void RunOutput::checkpoint(Simulation& simulation, const RunClock& clock, const std::string& case_text,
                           const RunCounts& counts) {
  writing_.wait();  // its particles need not be in memory beside these
  if (excluded_) excluded_->sync();
  if (auto packed = pack(simulation, FileContents::full_state, clock, [&] { return begin_checkpoint(folder_); })) {
    writing_.start([this, packed = std::move(*packed), case_text, counts] {
      lock_.require_folder();
      sync_series_tables();
      finish_checkpoint(*packed.file, packed.frame, case_text, counts);
    });
    return;
  }
  Checkpoint checkpoint{simulation.full_state(), case_text, counts};
  checkpoint.particles.info = info_at(clock);
  writing_.start([this, checkpoint = std::move(checkpoint)]() mutable {
    lock_.require_folder();
    sync_series_tables();
    write_checkpoint(folder_, std::move(checkpoint));
  });
}

void RunOutput::exclude(const std::vector<ExcludedParticle>& particles, const RunClock& clock) {
  if (particles.empty()) return;
  if (!excluded_) excluded_.emplace(folder_.excluded(), excluded_header, continued_at_);
  for (const ExcludedParticle& p : particles) {
    excluded_->add(fmt::format("{:.9g},{},{},{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}", clock.time, p.id, p.type,
                               p.position.x[0], p.position.x[1], p.position.x[2], p.velocity[0], p.velocity[1],
                               p.velocity[2]));
  }
}

std::filesystem::path RunOutput::write_diverged(Simulation& simulation, const RunClock& clock) {
  const auto file = folder_.diverged();
  if (const auto packed = pack(simulation, FileContents::snapshot, clock, [&] { return ranged_file(file); })) {
    writing_.wait();
    lock_.require_folder();
    packed->file->finish(packed->frame);
    return file;
  }
  ParticleSet particles = simulation.snapshot();
  particles.info = info_at(clock);
  writing_.wait();
  lock_.require_folder();
  write_particles(file, particles, PositionPrecision::single_precision, {}, {.make_folders = false});
  return file;
}

void RunOutput::finish(Simulation& simulation, const RunClock& clock, const RunCounts& counts, std::int64_t steps_now) {
  writing_.wait();
  lock_.require_folder();
  sync_series_tables();
  if (excluded_) excluded_->sync();
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
    row("steps_since_restart", steps_now, "-");
    row("restarts", counts.restarts, "-");
    row("wall_seconds", fmt::format("{:.3f}", counts.wall_seconds), "s");
    row("cpu_seconds", fmt::format("{:.3f}", counts.cpu_seconds), "s");
    row("particle_steps_per_second", fmt::format("{:.0f}", counts.particle_steps / std::max(1e-9, counts.wall_seconds)),
        "1/s");
    row("viscous_iterations_per_step", fmt::format("{:.2f}", static_cast<double>(counts.viscous_iterations) / steps),
        "-");
    row("viscous_retries", counts.viscous_retries, "-");
    row("pressure_sweeps_per_step", fmt::format("{:.2f}", static_cast<double>(counts.pressure_sweeps) / steps), "-");
    row("list_rebuilds", facts.list_rebuilds, "-");
    const double done = std::max(1.0, static_cast<double>(steps_now));
    row("fixed_launches", fmt::format("{:.3f}", static_cast<double>(facts.fixed_launches) / done), "-");
    row("repeated_launches", fmt::format("{:.3f}", static_cast<double>(facts.repeated_launches) / done), "-");
    row("neighbours_mean", fmt::format("{:.1f}", facts.neighbours_mean), "-");
    row("list_entries_per_particle", fmt::format("{:.1f}", facts.list_entries_per_particle), "-");
    if (facts.ranks > 1) {
      row("ranks", fmt::format("{}", facts.ranks), "-");
      row("copies_per_particle", fmt::format("{:.4f}", facts.copies_per_particle), "-");
      const auto sent = [&](const char* name, std::int64_t number, const char* unit) {
        row(name, fmt::format("{:.1f}", static_cast<double>(number) / done), unit);
      };
      sent("collectives_per_step", facts.sent.collectives, "-");
      sent("messages_per_step", facts.sent.messages, "-");
      sent("sent_bytes_per_step", facts.sent.bytes, "B");
      row("waited_per_step", fmt::format("{:.6f}", facts.waited / done), "s");
      row("waited_for_copies_per_step", fmt::format("{:.6f}", facts.waited_for_copies / done), "s");
      row("imbalance", fmt::format("{:.3f}", facts.imbalance), "-");
    }
    row("bytes_per_particle", fmt::format("{:.0f}", facts.bytes_per_particle), "B");
  });
}

}  // namespace thalweg
