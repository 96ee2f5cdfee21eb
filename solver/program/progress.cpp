#include "solver/program/progress.hpp"

#include <fmt/format.h>

namespace thalweg {

void Progress::show(double time, std::int64_t step, double dt, const char* limiter, double particle_steps) {
  line_.show([&] {
    const double elapsed = line_.elapsed();
    return progress_text(
        {.what = "solver",
         .share = time / end_,
         .begun_at = start_ / end_,
         .elapsed = elapsed,
         .facts = fmt::format("t = {:.4f} of {:g} s, step {}, dt {:.2e} s ({}), {:.2f} M particle-steps/s", time, end_,
                              step, dt, limiter, particle_steps / elapsed * 1e-6)});
  });
}

}  // namespace thalweg
