#pragma once

#include <filesystem>
#include <vector>

namespace thalweg::foam {

/// Rows of numbers of a function object's file; comment lines start with #. Throws RunError if there is no such file.
std::vector<std::vector<double>> read_table(const std::filesystem::path& file);

}  // namespace thalweg::foam
