#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "common/particles.hpp"

namespace thalweg {

/// The contents of a particle file beside the arrays of particles.
struct ParticleFrame {
  ParticleSet set;  // info and facts
  std::map<std::string, std::string> texts;
  std::optional<float> mass;  // that all particles have [kg]
};

/// Reads them from the text of a file from which the particles were taken out, `particles` in number. Throws InputError, which
/// names `file`.
ParticleFrame read_particle_frame(const std::filesystem::path& file, const std::string& text, std::uint64_t particles);

}  // namespace thalweg
