#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace thalweg {

/// Says what is in a particle file, a series or a run's folder: counts, masses, bounds, times, memory.
/// Throws InputError when it is none of these or cannot be read.
void print_info(std::ostream& to, const std::filesystem::path& file_or_folder);

/// The same as a JSON object; a run's folder has one part for each of its files.
std::string info_json(const std::filesystem::path& file_or_folder);

}  // namespace thalweg
