#pragma once

#include <filesystem>

#include "common/particles.hpp"

namespace thalweg {

/// Refuses a particle set that no run can start from: arrays or facts that are missing, numbers that are not finite or
/// cannot be, ids given twice, points that coincide, no fluid, a plane scene out of the plane y = 0. `spacing` [m] is
/// the case's. Throws InputError "file: what is wrong; what to do".
void check_start(const ParticleSet& particles, const std::filesystem::path& file, int dimension, double spacing);

}  // namespace thalweg
