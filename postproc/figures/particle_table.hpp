#pragma once

#include <filesystem>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// A table of particles to draw: x, z [m], kind (0 water, 1 sediment without state, 2 deposit, 3 bed load, 4 suspended,
/// 5 wall), speed [m/s] and pressure [Pa].
struct ParticleTable {
  std::filesystem::path file;
  std::vector<std::size_t> kinds;  // that occur
  double fastest = 0;              // [m/s]
  double highest_pressure = 0;     // [Pa]
};

/// Writes the water and sediment (and walls) within half a spacing of the plane y, at most `limit` of them (every
/// n-th). Throws RunError.
ParticleTable write_particle_table(const std::filesystem::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit, bool with_walls = false);

}  // namespace thalweg
