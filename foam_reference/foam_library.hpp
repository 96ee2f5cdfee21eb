#pragma once

#include <filesystem>
#include <optional>

namespace thalweg::foam {

/// Folder of libthalwegFoam.so, our models for OpenFOAM, built now if it has not been yet (tools/foam-library, which
/// says on stderr what it does and why it cannot). Nothing where it cannot be had.
std::optional<std::filesystem::path> foam_library();

}  // namespace thalweg::foam
