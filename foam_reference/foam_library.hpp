#pragma once

#include <filesystem>
#include <optional>

namespace thalweg::foam {

/// Folder of libthalwegFoam.so, our models for OpenFOAM. tools/foam-library builds it the first time, and tells on
/// stderr the progress or the reason of a failure. Nothing if the library cannot be had.
std::optional<std::filesystem::path> foam_library();

}  // namespace thalweg::foam
