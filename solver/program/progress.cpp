#include "solver/program/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace thalweg {

Progress::Progress(double end, double start) : end_(end), start_(start), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::show(double time, std::int64_t step, double dt, const char* limiter, double particle_steps) {
  const auto now = Clock::now();
  const double pause = terminal_ ? 0.2 : 10.0;  // [s]
  if (std::chrono::duration<double>(now - last_).count() < pause) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - begun_).count();
  const double left = time > start_ ? elapsed * (end_ - time) / (time - start_) : 0;
  const std::string line =
      fmt::format("t = {:.4f} of {:g} s  step {}  dt = {:.2e} s ({})  {:.2f} M particle-steps/s  ETA {:.0f} s", time,
                  end_, step, dt, limiter, particle_steps / elapsed * 1e-6, left);
  if (terminal_) {
    fmt::print(stderr, "\r{:<110}", line);
    shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\n");
  shown_ = false;
}

}  // namespace thalweg
