#pragma once

#include <cstdint>
#include <string>

namespace thalweg {

/// What a run of this many particles will need [bytes]; estimates for announcements and refusals.
struct MemoryEstimate {
  double solver = 0;  // records, neighbour lists and the state of the step; on a GPU in the GPU's memory
  double host = 0;    // particle arrays while files are read and written
  [[nodiscard]] double total() const { return solver + host; }
};

MemoryEstimate estimate_memory(double particles, int dimension);

/// Memory of this machine [bytes].
double machine_memory();

/// "1.5 GB" (powers of 1000).
std::string format_bytes(double bytes);

/// Smallest spacing [m], rounded up to two digits, at which `needed` bytes at `spacing` shrink to `available`.
double spacing_that_fits(double spacing, double needed, double available, int dimension);

}  // namespace thalweg
