#pragma once

#include <filesystem>
#include <vector>

#include "common/particles.hpp"

namespace thalweg::foam {

/// Values in the cells of a volScalarField file, ascii or binary, in the mesh's order; a uniform field gives one value.
/// Throws RunError that names the file and its fault.
std::vector<double> read_scalar_field(const std::filesystem::path& file);

/// The same of a volVectorField file.
std::vector<Vec3> read_vector_field(const std::filesystem::path& file);

}  // namespace thalweg::foam
