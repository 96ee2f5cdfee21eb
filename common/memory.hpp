#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace thalweg {

/// What a run of this many particles will need [bytes]; estimates for announcements and refusals.
struct MemoryEstimate {
  double solver = 0;  // records, neighbour lists and the state of the step on CPU cores
  double gpu = 0;     // the same in a GPU's memory, without a number a pair (Gpu::stores_coefficients)
  double host = 0;    // particle arrays while files are read and written
  [[nodiscard]] double total() const { return solver + host; }
};

MemoryEstimate estimate_memory(double particles, int dimension);

/// Memory a program can still take [bytes]: what the kernel says is available (MemAvailable), or what is left under the
/// lowest limit of the control groups this process is in, page cache not counted. `root` is for tests.
double available_memory(const std::filesystem::path& root = "/");

/// "1.5 GB" (powers of 1000).
std::string format_bytes(double bytes);

/// Smallest spacing [m], rounded up to two digits, at which `needed` bytes at `spacing` shrink to `available`.
double spacing_that_fits(double spacing, double needed, double available, int dimension);

}  // namespace thalweg
