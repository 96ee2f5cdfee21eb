#include "solver/program/progress.hpp"

#include <fmt/format.h>

namespace thalweg {

void Progress::show(double time, std::int64_t step, double dt, const char* limiter, double particle_steps) {
  line_.show([&] {
    const double elapsed = line_.elapsed();
    const double left = time > start_ ? elapsed * (end_ - time) / (time - start_) : 0;
    return fmt::format("t = {:.4f} of {:g} s  step {}  dt = {:.2e} s ({})  {:.2f} M particle-steps/s  ETA {:.0f} s",
                       time, end_, step, dt, limiter, particle_steps / elapsed * 1e-6, left);
  });
}

}  // namespace thalweg
