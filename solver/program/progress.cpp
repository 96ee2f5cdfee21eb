#include "solver/program/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace thalweg {
namespace {

std::string bed_text(double now, double end) {
  if (end > 0) return fmt::format("bed {:.4g} of {:g} s, ", now, end);
  return now > 0 ? fmt::format("bed {:.4g} s, ", now) : "";
}

}  // namespace

double share_done(const RunTimes& now, const RunTimes& end) {
  return std::max(now.time / end.time, end.bed_time > 0 ? now.bed_time / end.bed_time : 0);
}

void Progress::show(const RunTimes& now, std::int64_t step, double dt, const char* limiter, double particle_steps) {
  line_.show([&] {
    const double elapsed = line_.elapsed();
    return progress_text(
        {.what = "solver",
         .share = share_done(now, end_),
         .begun_at = begun_at_,
         .elapsed = elapsed,
         .facts = fmt::format("t = {:.4f} of {:g} s, {}step {}, dt {:.2e} s ({}), {:.2f} M particle-steps/s", now.time,
                              end_.time, bed_text(now.bed_time, end_.bed_time), step, dt, limiter,
                              particle_steps / elapsed * 1e-6)});
  });
}

}  // namespace thalweg
