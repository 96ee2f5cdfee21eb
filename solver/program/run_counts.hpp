#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace thalweg {

/// Time and step that a run has reached.
struct RunClock {
  double time = 0;  // [s]
  std::int64_t step = 0;
};

/// Counts of the run loop, for history and summary: of the whole run, over all restarts. A checkpoint carries them.
struct RunCounts {
  std::int64_t excluded = 0;
  std::int64_t viscous_iterations = 0;
  std::int64_t viscous_retries = 0;
  std::int64_t pressure_sweeps = 0;
  std::int64_t steps = 0;
  std::int64_t restarts = 0;
  double wall_seconds = 0;
  double cpu_seconds = 0;
  double particle_steps = 0;  // fluid particles times steps
};

/// The counts as numbers of a file, and back.
inline constexpr std::size_t numbers_in_counts = 9;
inline std::array<double, numbers_in_counts> numbers_of(const RunCounts& c) {
  return {static_cast<double>(c.excluded),
          static_cast<double>(c.viscous_iterations),
          static_cast<double>(c.viscous_retries),
          static_cast<double>(c.pressure_sweeps),
          static_cast<double>(c.steps),
          static_cast<double>(c.restarts),
          c.wall_seconds,
          c.cpu_seconds,
          c.particle_steps};
}
inline RunCounts counts_of(const std::array<double, numbers_in_counts>& n) {
  const auto whole = [&](std::size_t i) { return static_cast<std::int64_t>(n[i]); };
  return {whole(0), whole(1), whole(2), whole(3), whole(4), whole(5), n[6], n[7], n[8]};
}

}  // namespace thalweg
