#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "common/particles.hpp"
#include "common/position_precision.hpp"

namespace thalweg {

/// The text of a particle file, without a seal, whose `total` particles are not in memory. `extremes`
/// has two for them, the least and the largest entry of every array: so the text is that of the file but for the bodies of the
/// arrays of particles.
std::string particle_skeleton(const std::filesystem::path& file, const ParticleSet& extremes, std::int64_t total,
                              PositionPrecision precision, const std::map<std::string, std::string>& texts);

}  // namespace thalweg
