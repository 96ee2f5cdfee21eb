#include "measures.hpp"

#include <algorithm>
#include <cmath>

#include "common/extraction/profile_extraction.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "postproc/comparison.hpp"

namespace thalweg::test {
namespace {

double gravity(const FinishedRun& run) { return run.scene.domain.gravity.norm(); }
double spacing(const FinishedRun& run) { return run.scene.numerics.spacing; }

double fluid_mass(const ParticleSet& p) {
  const auto mass = mass_by_type(p);
  return mass[static_cast<std::size_t>(ParticleType::water)] + mass[static_cast<std::size_t>(ParticleType::sediment)];
}

/// Height of the particles at the start that `counts` selects [m].
double height_of(const FinishedRun& run, bool (*counts)(ParticleType)) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < run.start.size(); ++i) {
    if (!counts(run.start.type[i])) continue;
    low = std::min(low, run.start.position[i].z());
    high = std::max(high, run.start.position[i].z());
  }
  return high - low + spacing(run);
}

double fluid_height(const FinishedRun& run) { return height_of(run, is_fluid); }
double sediment_height(const FinishedRun& run) {
  return height_of(run, [](ParticleType type) { return type == ParticleType::sediment; });
}

/// Largest departure of a column of the history from its first value, over that value.
double relative_change(const CsvTable& history, const char* name, const char* unit) {
  const auto values = history.numbers(name, unit);
  double change = 0;
  for (const double v : values) change = std::max(change, std::abs(v - values[0]));
  return values[0] > 0 ? change / values[0] : change;
}

double water_mass_change(const FinishedRun& run) { return relative_change(run.history, "water_mass", "kg"); }
double sediment_mass_change(const FinishedRun& run) { return relative_change(run.history, "sediment_mass", "kg"); }

double excluded(const FinishedRun& run) {
  const auto counts = run.history.numbers("excluded", "-");
  return *std::max_element(counts.begin(), counts.end());
}

double not_finite(const FinishedRun& run) {
  double n = 0;
  for (const ParticleSet& s : run.snapshots) n += count_not_finite(s);
  return n;
}

/// Kinetic, potential and internal energy of the history's rows, as the height in spacings to which it would lift all
/// fluid. The work of gravity is in the potential energy and all else dissipates: the sum may not rise.
std::vector<double> energies(const FinishedRun& run) {
  const auto kinetic = run.history.numbers("kinetic_energy", "J");
  const auto potential = run.history.numbers("potential_energy", "J");
  const auto internal = run.history.numbers("internal_energy", "J");
  const double lift = fluid_mass(run.start) * gravity(run) * spacing(run);
  std::vector<double> out;
  for (std::size_t i = 0; i < kinetic.size(); ++i) out.push_back((kinetic[i] + potential[i] + internal[i]) / lift);
  return out;
}

double energy_gain(const FinishedRun& run) {
  double lowest = HUGE_VAL;
  double gain = 0;
  for (const double energy : energies(run)) {
    lowest = std::min(lowest, energy);
    gain = std::max(gain, energy - lowest);
  }
  return gain;
}

double energy_above_start(const FinishedRun& run) {
  const auto all = energies(run);
  return *std::max_element(all.begin(), all.end()) - all[0];
}

double steps_over_acoustic(const FinishedRun& run) {
  const Numerics& n = run.scene.numerics;
  const double acoustic = n.cfl * run.scene.smoothing_length() / (n.sound_speed_factor * n.maximum_speed);
  return run.steps * acoustic / run.scene.output.end;
}

/// Height from the highest place of the fluid at the start to the lowest place it has reached [m].
double fall_height(const FinishedRun& run) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < run.start.size(); ++i) {
    if (is_fluid(run.start.type[i])) high = std::max(high, run.start.position[i].z());
  }
  for (const ParticleSet& s : run.snapshots) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (is_fluid(s.type[i])) low = std::min(low, s.position[i].z());
    }
  }
  return high - low;
}

double speed_over_fall(const FinishedRun& run) {
  const auto speeds = run.history.numbers("max_speed", "m/s");
  return *std::max_element(speeds.begin(), speeds.end()) / std::sqrt(2 * gravity(run) * fall_height(run));
}

double compression(const FinishedRun& run) {
  double most = 0;
  for (const ParticleSet& s : run.snapshots) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (!is_fluid(s.type[i])) continue;
      const double rest =
          s.type[i] == ParticleType::water ? run.scene.water.density : run.scene.sediment().bed_density();
      most = std::max(most, std::abs(double(s.density[i]) / rest - 1));
    }
  }
  return most;
}

/// Sum of all viscous iterations of the history's rows over their number.
double viscous_iterations(const FinishedRun& run) {
  const auto rows = run.history.numbers("viscous_iterations", "-");
  double sum = 0;
  for (const double n : rows) sum += n;
  return sum / static_cast<double>(rows.size());
}

/// Distance of each sediment particle at the end from its place at the start [m].
std::vector<double> displacements(const FinishedRun& run) {
  std::map<std::int64_t, Vec3> before;
  for (std::size_t i = 0; i < run.start.size(); ++i) before[run.start.id[i]] = run.start.position[i];
  std::vector<double> out;
  const ParticleSet& end = run.end();
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] == ParticleType::sediment) out.push_back((end.position[i] - before.at(end.id[i])).norm());
  }
  return out;
}

double root_mean_square_creep(const FinishedRun& run) {
  double sum = 0;
  const auto all = displacements(run);
  for (const double d : all) sum += d * d;
  return std::sqrt(sum / static_cast<double>(all.size())) / spacing(run);
}

double largest_creep(const FinishedRun& run) {
  const auto all = displacements(run);
  return *std::max_element(all.begin(), all.end()) / spacing(run);
}

double water_speed(const FinishedRun& run) {
  double sum = 0;
  double count = 0;
  const ParticleSet& end = run.end();
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] != ParticleType::water) continue;
    sum += double(end.velocity[i].squaredNorm());
    ++count;
  }
  return std::sqrt(sum / count / (gravity(run) * fluid_height(run)));
}

/// |sum m u - M g t| / (M g t): without walls gravity is the only outside force.
double momentum_error(const FinishedRun& run) {
  const ParticleSet& end = run.end();
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < end.size(); ++i) momentum += double(end.mass[i]) * end.velocity[i].cast<double>();
  const Vec3 impulse = fluid_mass(run.start) * run.scene.output.end * run.scene.domain.gravity;
  return (momentum - impulse).norm() / impulse.norm();
}

Profile final_profile(const FinishedRun& run) {
  ExtractionSettings settings;
  settings.x_from = run.scene.domain.from.x();
  settings.x_to = run.scene.domain.to.x();
  return extract_profile(run.end(), settings).profile;
}

/// Slope of the straight line through the bed between a quarter and three quarters of the heap's height at the start.
double final_slope(const FinishedRun& run) {
  const Profile profile = final_profile(run);
  const double height = sediment_height(run);
  double n = 0, x = 0, z = 0, xx = 0, xz = 0;
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    const double at = profile.bed[i];
    if (!(at > height / 4 && at < 3 * height / 4)) continue;
    n += 1, x += profile.x[i], z += at, xx += profile.x[i] * profile.x[i], xz += profile.x[i] * at;
  }
  return std::atan2(-(n * xz - x * z), n * xx - x * x) * 180 / M_PI;
}

Profile measured_surface(const FinishedRun& run) {
  return read_profile(run.scene.folder / "reference" / profile_file_name(run.scene.output.end));
}

/// End of a deposit against the left wall [m]: the first x at which its bed falls below `level`, linear between points.
/// A thin film that has slid further does not belong to the deposit.
double toe(const Profile& profile, double level) {
  for (std::size_t i = 1; i < profile.x.size(); ++i) {
    const double inner = profile.bed[i - 1];
    const double outer = profile.bed[i] > 0 ? profile.bed[i] : 0;  // a column without sediment has no value
    if (inner > level && outer <= level) {
      return profile.x[i - 1] + (profile.x[i] - profile.x[i - 1]) * (inner - level) / (inner - outer);
    }
  }
  return NAN;
}

double runout_error(const FinishedRun& run) {
  const Profile measured = measured_surface(run);
  const double level = 2 * measured.bed.back();
  return toe(final_profile(run), level) / toe(measured, level) - 1;
}

double surface_error(const FinishedRun& run) {
  const double end = run.scene.output.end;
  const ProfileSet measured{"measured", SourceKind::other, {}, {{end, {}, measured_surface(run)}}};
  const ProfileSet computed{"computed", SourceKind::other, {}, {{end, {}, final_profile(run)}}};
  for (const CurveError& e :
       compare(measured, computed, {run.scene.domain.from.x(), run.scene.domain.to.x(), 0}).errors) {
    if (e.curve == "bed") return e.rmse / sediment_height(run);
  }
  return NAN;
}

}  // namespace

double count_not_finite(const ParticleSet& particles) {
  double n = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool finite = particles.position[i].allFinite() && particles.velocity[i].allFinite() &&
                        std::isfinite(particles.density[i]) && std::isfinite(particles.pressure[i]);
    n += finite ? 0 : 1;
  }
  return n;
}

FinishedRun read_run(const Case& scene, const ParticleSet& start, const std::filesystem::path& folder) {
  const RunFolder run{folder};
  FinishedRun out{scene, start, {}, CsvTable::read(run.history())};
  for (const SeriesEntry& e : read_series(run.snapshot_series()))
    out.snapshots.push_back(read_particles(folder / e.file));
  const CsvTable summary = CsvTable::read(run.summary());
  const auto names = summary.texts("quantity");
  const auto values = summary.texts("value");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == "steps") out.steps = std::stod(values[i]);
    if (names[i] == "fluid_particles") out.fluid_particles = std::stod(values[i]);
    if (names[i] == "cpu_seconds") out.cpu_seconds = std::stod(values[i]);
  }
  return out;
}

const std::map<std::string, Measure>& measures() {
  static const std::map<std::string, Measure> all = {
      {"water_mass", {"-", "largest change of the water's mass, relative", water_mass_change}},
      {"sediment_mass", {"-", "largest change of the sediment's mass, relative", sediment_mass_change}},
      {"excluded", {"particles", "left the domain", excluded}},
      {"not_finite", {"particles", "with a number that is not finite, in any snapshot", not_finite}},
      {"energy_gain",
       {"dp", "rise of the total energy above its lowest value so far, as a lift of all fluid", energy_gain}},
      {"energy_above_start", {"dp", "rise of the total energy above its first value, likewise", energy_above_start}},
      {"steps", {"-", "steps taken over those of the acoustic limit", steps_over_acoustic}},
      {"speed",
       {"-", "largest speed over that of a fall from the fluid's highest place at the start to its lowest",
        speed_over_fall}},
      {"compression", {"-", "largest departure of a density from rest, relative", compression}},
      {"viscous_iterations", {"-", "of the implicit viscosity, mean of the history's rows", viscous_iterations}},
      {"creep", {"dp", "displacement of the sediment, root mean square", root_mean_square_creep}},
      {"largest_creep", {"dp", "displacement of the sediment, largest", largest_creep}},
      {"water_speed", {"sqrt(g H)", "speed of the water at the end, root mean square", water_speed}},
      {"momentum", {"-", "momentum less impulse of gravity, over the impulse", momentum_error}},
      {"slope",
       {"deg", "slope of the bed at the end, between a quarter and three quarters of the start's height", final_slope}},
      {"runout", {"-", "toe of the deposit over the measured one, less 1", runout_error}},
      {"surface", {"H", "final surface against the measured one, root mean square", surface_error}},
  };
  return all;
}

}  // namespace thalweg::test
