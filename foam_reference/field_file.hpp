#pragma once

#include <filesystem>
#include <vector>

namespace thalweg::foam {

/// Values in the cells of a volScalarField file, ascii or binary, in the mesh's order; a uniform field gives one value.
/// Throws RunError that names the file and its fault.
std::vector<double> read_scalar_field(const std::filesystem::path& file);

}  // namespace thalweg::foam
