#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace thalweg {

/// Memory that a run needs [bytes]: estimates, by which a scene is announced or refused.
struct MemoryEstimate {
  double solver = 0;  // records, neighbour lists and the state of the step on CPU cores
  double gpu = 0;     // the same in a GPU's memory, without a number a pair (Gpu::stores_coefficients)
  double host = 0;    // particle arrays while files are read and written
  [[nodiscard]] double total() const { return solver + host; }
};

/// The memory for a run with this many particles; `dimension` is 2 or 3.
MemoryEstimate estimate_memory(double particles, int dimension);

/// Memory that a program can still allocate [bytes]: MemAvailable of the kernel, or less if a control group of this
/// process has less left below its limit; page cache does not count as used. `root` is for tests.
double available_memory(const std::filesystem::path& root = "/");

/// "1.5 GB" (powers of 1000).
std::string format_bytes(double bytes);

/// Smallest spacing [m], rounded up to two digits, at which `needed` bytes at `spacing` shrink to `available`.
double spacing_that_fits(double spacing, double needed, double available, int dimension);

}  // namespace thalweg
