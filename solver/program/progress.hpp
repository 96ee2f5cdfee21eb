#pragma once

#include <chrono>
#include <cstdint>

namespace thalweg {

/// The line that tells how far a run is: on a terminal one line that is rewritten, elsewhere a line now and then.
class Progress {
 public:
  Progress(double end, double start);

  void show(double time, std::int64_t step, double dt, const char* limiter, double particle_steps);
  /// Ends the line on a terminal, so that what follows starts on its own.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double end_;
  double start_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = Clock::now();
};

}  // namespace thalweg
