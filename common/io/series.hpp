#pragma once

#include <filesystem>
#include <vector>

#include "common/whole_file.hpp"

namespace thalweg {

/// One file of a time series; `file` is relative to the folder of the .pvd.
struct SeriesEntry {
  double time = 0;  // [s]
  std::filesystem::path file;
};

/// Writes a ParaView collection (.pvd), whole or not at all (temporary name, then rename). Throws RunError.
void write_series(const std::filesystem::path& pvd, const std::vector<SeriesEntry>& entries, const WholeFile& how = {});

/// Reads a .pvd written by write_series, in order of time. Throws InputError "file: what is wrong; what to do".
std::vector<SeriesEntry> read_series(const std::filesystem::path& pvd);

}  // namespace thalweg
