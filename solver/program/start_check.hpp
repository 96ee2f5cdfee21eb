#pragma once

#include <filesystem>

#include "case/case.hpp"
#include "common/particle_source.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// Throws InputError for particles from which no run can start: none of them fluid, two with one id or in one place,
/// numbers that are none, masses or densities that are not positive, another spacing or dimension than the case's.
/// `file` is named in the message.
void check_start(const ParticleSet& particles, const std::filesystem::path& file, const Case& scene);

/// The same of particles that are read range by range, but for two with one id or in one place, which are found when they are dealt
/// out (start.hpp). Returns the largest speed of the walls until the end of the case [m/s].
double check_start(ParticleSource& particles, const std::filesystem::path& file, const Case& scene);

}  // namespace thalweg
