#include "postproc/figures/particle_table.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/extraction/parts.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The number of a particle's kind, as ParticleTable lists them.
std::size_t kind_of(const ParticleSet& particles, std::size_t i) {
  switch (particles.type[i]) {
    case ParticleType::wall:
    case ParticleType::moving_wall:
      return 5;
    case ParticleType::water:
      return 0;
    case ParticleType::sediment:
      break;
  }
  return particles.state.empty() ? 1 : 1 + static_cast<std::size_t>(particles.state[i]);
}

}  // namespace

ParticleTable write_particle_table(const fs::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit, bool with_walls) {
  ParticleTable table{file, {}, 0, 0};
  // A plane between two layers of the lattice lies half a spacing from both; rounding must not take both away.
  const double half = 0.5 * (1 + 1e-3) * particles.info.spacing;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool in_plane = particles.info.dimension == 2 || std::abs(particles.position[i].y() - plane_y) <= half;
    if ((with_walls || is_fluid(particles.type[i])) && in_plane) shown.push_back(i);
  }
  const std::size_t every = std::max<std::size_t>(1, (shown.size() + limit - 1) / std::max<std::size_t>(1, limit));
  std::set<std::size_t> kinds;
  write_whole_text(file, [&](std::ostream& stream) {
    fmt::print(stream, "# t = {:g} s; every {}. particle\nx [m],z [m],kind,speed [m/s],pressure [Pa]\n",
               particles.info.time, every);
    for (std::size_t n = 0; n < shown.size(); n += every) {
      const std::size_t i = shown[n];
      const std::size_t kind = kind_of(particles, i);
      kinds.insert(kind);
      const float speed = particles.velocity.empty() ? 0.F : particles.velocity[i].norm();
      const float pressure = particles.pressure.empty() ? 0.F : particles.pressure[i];
      table.fastest = std::max(table.fastest, static_cast<double>(speed));
      table.highest_pressure = std::max(table.highest_pressure, static_cast<double>(pressure));
      fmt::print(stream, "{:.6g},{:.6g},{},{:.5g},{:.5g}\n", particles.position[i].x(), particles.position[i].z(), kind,
                 speed, pressure);
    }
  });
  table.kinds.assign(kinds.begin(), kinds.end());
  return table;
}

}  // namespace thalweg
