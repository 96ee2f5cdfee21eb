#include "postproc/velocity_stations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "case/models/driven_flow.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg {
namespace {

constexpr std::size_t most_snapshots = 20;
constexpr std::array shares_of_length{0.25, 0.5, 0.75};

/// Sums over the water around one place.
struct Sums {
  double ground = std::numeric_limits<double>::max();  // [m] lowest water
  double volume = 0;                                   // [m^3] (2-D: [m^2])
  double flow = 0;                                     // volume times velocity
  std::map<int, double> velocity;                      // by the row, counted from z = 0
  std::map<int, double> number;
};

/// The way of a current: component of vectors, direction, and two ends [m].
struct Way {
  int component = 0;
  double sign = 1;
  double from = std::numeric_limits<double>::max();
  double to = std::numeric_limits<double>::lowest();
};

Way way_of(const Case& of, const ParticleSet& particles) {
  Way way;
  way.component = of.flow.component();
  if (!of.inlets.empty()) {
    const Vec3 direction = of.inlets.front().axes().flow;
    way.component = std::abs(direction.x()) >= std::abs(direction.y()) ? 0 : 1;
    way.sign = direction[way.component] < 0 ? -1 : 1;
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    way.from = std::min(way.from, particles.position[i][way.component]);
    way.to = std::max(way.to, particles.position[i][way.component]);
  }
  if (!of.inlets.empty() && !of.outlets.empty()) {
    const double in = of.inlets.front().at[way.component];
    const double out = of.outlets.front().at[way.component];
    way.from = std::min(in, out);
    way.to = std::max(in, out);
  }
  return way;
}

/// The particles of a file; none of one that cannot be read, which the extraction of profiles names in its warnings.
std::optional<ParticleSet> readable(const std::filesystem::path& file) {
  try {
    return read_particles(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void add(const ParticleSet& particles, const Way& way, double place, double reach, double spacing, Sums& sums) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    const Vec3& at = particles.position[i];
    if (std::abs(at[way.component] - place) > reach) continue;
    const double u = way.sign * double(particles.velocity[i][way.component]);
    const double volume = double(particles.mass[i]) / double(particles.density[i]);
    const int row = static_cast<int>(std::floor(at.z() / spacing));
    sums.ground = std::min(sums.ground, at.z());
    sums.volume += volume;
    sums.flow += volume * u;
    sums.velocity[row] += u;
    sums.number[row] += 1;
  }
}

/// Root of the mean square of velocity minus law over the mean velocity [-]; 0 without rows or a current.
double deviation_of(const VelocityStation& station) {
  if (station.height.empty() || !(station.mean_velocity > 0)) return 0;
  double squares = 0;
  for (std::size_t row = 0; row < station.height.size(); ++row) {
    squares += std::pow(station.velocity[row] - station.law[row], 2);
  }
  return std::sqrt(squares / static_cast<double>(station.height.size())) / station.mean_velocity;
}

VelocityStation station_of(const Case& of, const Sums& sums, double place, double area, double snapshots) {
  const double spacing = of.numerics.spacing;
  VelocityStation station;
  station.place = place;
  station.ground = sums.ground - 0.5 * spacing;
  station.depth = sums.volume / area / snapshots;
  station.mean_velocity = sums.flow / sums.volume;
  const double viscosity = of.water.viscosity / of.water.density;
  const double roughness = roughness_of_current(of);
  if (station.mean_velocity > 0) {
    station.friction_velocity =
        friction_velocity_of_current(station.mean_velocity, station.depth, viscosity, roughness);
  }
  const double full = area / std::pow(spacing, of.info.dimension - 1) * snapshots;  // particles of a row
  for (const auto& [row, number] : sums.number) {
    if (number < 0.5 * full) continue;
    const double height = (row + 0.5) * spacing - station.ground;
    const double velocity = sums.velocity.at(row) / number;
    const double law = station.friction_velocity > 0
                           ? log_profile(station.friction_velocity, std::max(0.0, height), viscosity, roughness)
                           : 0;
    station.height.push_back(height);
    station.velocity.push_back(velocity);
    station.law.push_back(law);
  }
  station.deviation = deviation_of(station);
  return station;
}

}  // namespace

std::vector<VelocityStation> velocity_stations(const Case& of, const std::vector<SeriesEntry>& snapshots) {
  if (!of.has_lasting_current() || !(of.water.viscosity > 0)) return {};
  std::vector<const SeriesEntry*> late;
  for (const SeriesEntry& entry : snapshots) {
    if (entry.time > 0 && entry.time >= 0.5 * snapshots.back().time) late.push_back(&entry);
  }
  if (late.empty()) return {};
  const std::size_t stride = (late.size() + most_snapshots - 1) / most_snapshots;
  const double reach = 4 * of.numerics.spacing;
  std::array<Sums, shares_of_length.size()> sums;
  Way way;
  double read = 0;
  for (std::size_t n = 0; n < late.size(); n += stride) {
    const std::optional<ParticleSet> snapshot = readable(late[n]->file);
    if (!snapshot) continue;
    const ParticleSet& particles = *snapshot;
    if (read == 0) way = way_of(of, particles);
    read += 1;
    for (std::size_t s = 0; s < shares_of_length.size(); ++s) {
      add(particles, way, way.from + shares_of_length.at(s) * (way.to - way.from), reach, of.numerics.spacing,
          sums.at(s));
    }
  }
  const int across = 1 - way.component;
  const double width = of.info.dimension == 3 ? of.domain.to[across] - of.domain.from[across] : 1;
  std::vector<VelocityStation> stations;
  for (std::size_t s = 0; s < shares_of_length.size(); ++s) {
    if (!(sums.at(s).volume > 0)) continue;
    const double place = way.from + shares_of_length.at(s) * (way.to - way.from);
    stations.push_back(station_of(of, sums.at(s), place, 2 * reach * width, read));
  }
  return stations;
}

void write_velocity_stations(const std::filesystem::path& file, const std::vector<VelocityStation>& stations) {
  CsvTable table({{"place", "m"}, {"height", "m"}, {"velocity", "m/s"}, {"law", "m/s"}});
  for (const VelocityStation& station : stations) {
    for (std::size_t row = 0; row < station.height.size(); ++row) {
      table.add_row({csv_number(station.place), csv_number(station.height[row]), csv_number(station.velocity[row]),
                     csv_number(station.law[row])});
    }
  }
  table.write(file);
}

std::vector<VelocityStation> read_velocity_stations(const std::filesystem::path& file) {
  std::vector<VelocityStation> stations;
  if (!std::filesystem::exists(file)) return stations;
  const CsvTable table = CsvTable::read(file);
  const auto column = [&](const char* name, const char* unit) { return table.numbers(name, unit); };
  const std::vector<double> place = column("place", "m");
  const std::vector<double> height = column("height", "m");
  const std::vector<double> velocity = column("velocity", "m/s");
  const std::vector<double> law = column("law", "m/s");
  const std::vector<double> ground = column("ground", "m");
  const std::vector<double> depth = column("depth", "m");
  const std::vector<double> mean = column("mean_velocity", "m/s");
  const std::vector<double> friction = column("friction_velocity", "m/s");
  for (std::size_t row = 0; row < place.size(); ++row) {
    if (stations.empty() || stations.back().place != place[row]) {
      stations.push_back({place[row], ground[row], depth[row], mean[row], friction[row], 0, {}, {}, {}});
    }
    stations.back().height.push_back(height[row]);
    stations.back().velocity.push_back(velocity[row]);
    stations.back().law.push_back(law[row]);
  }
  for (VelocityStation& station : stations) station.deviation = deviation_of(station);
  return stations;
}

}  // namespace thalweg
