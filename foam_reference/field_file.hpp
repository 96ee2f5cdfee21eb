#pragma once

#include <filesystem>
#include <vector>

namespace thalweg::foam {

/// Values in the cells of a volScalarField file, ascii or binary, in the mesh's order; a uniform field gives one value.
/// Throws RunError naming the file and what is wrong with it.
std::vector<double> read_scalar_field(const std::filesystem::path& file);

}  // namespace thalweg::foam
