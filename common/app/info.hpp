#pragma once

#include <filesystem>
#include <iosfwd>

namespace thalweg {

/// Says what is in a particle file, a series or a run's folder: counts, masses, bounds, times, memory.
/// Throws InputError when it is none of these or cannot be read.
void print_info(std::ostream& to, const std::filesystem::path& file_or_folder);

}  // namespace thalweg
