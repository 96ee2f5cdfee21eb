#pragma once

#include <cstdint>

#include "common/progress.hpp"

namespace thalweg {

/// Times of a run [s].
struct RunTimes {
  double time = 0;
  double bed_time = 0;  // of a bed that is a surface; as an end: 0 if it does not end the run
};

/// Share of a run that is done [-]: whichever of its ends is nearer.
double share_done(const RunTimes& now, const RunTimes& end);

/// Shows how far a run is.
class Progress {
 public:
  Progress(const RunTimes& end, const RunTimes& start) : end_(end), begun_at_(share_done(start, end)) {}

  /// Times now; step number; its length [s] and what limits it; steps times particles since the start.
  void show(const RunTimes& now, std::int64_t step, double dt, const char* limiter, double particle_steps);
  /// Ends the line, so that the text after it begins on a line of its own.
  void clear() { line_.finish(); }

 private:
  RunTimes end_;
  double begun_at_;  // share done
  ProgressLine line_{{.width = 130}};
};

}  // namespace thalweg
