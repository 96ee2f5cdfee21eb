#pragma once

#include <chrono>
#include <ctime>

namespace thalweg {

/// Wall-clock time and processor time of all threads since it was made [s].
class Stopwatch {
 public:
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }
  [[nodiscard]] double cpu() const { return static_cast<double>(std::clock() - cpu_begun_) / CLOCKS_PER_SEC; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begun_ = Clock::now();
  std::clock_t cpu_begun_ = std::clock();
};

}  // namespace thalweg
