#pragma once

#include <cstdint>

#include "common/progress.hpp"

namespace thalweg {

/// Shows how far a run is.
class Progress {
 public:
  /// End and start of the run [s].
  Progress(double end, double start) : end_(end), start_(start) {}

  /// Simulated time [s]; step number; its length [s] and what limits it; steps times particles since the start.
  void show(double time, std::int64_t step, double dt, const char* limiter, double particle_steps);
  /// Ends the line, so that the text after it begins on a line of its own.
  void clear() { line_.finish(); }

 private:
  double end_;
  double start_;
  ProgressLine line_{{.width = 130}};
};

}  // namespace thalweg
