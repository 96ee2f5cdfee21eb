#pragma once

#include <filesystem>

#include "case/case.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// Throws InputError for particles from which no run can start: none of them fluid, two with one id or in one place,
/// numbers that are none, masses or densities that are not positive, another spacing or dimension than the case's.
/// `file` is named in the message.
void check_start(const ParticleSet& particles, const std::filesystem::path& file, const Case& scene);

}  // namespace thalweg
