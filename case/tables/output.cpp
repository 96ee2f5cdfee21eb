#include "case/tables/output.hpp"

#include <fmt/format.h>

#include "case/tables/common_checks.hpp"

namespace thalweg {

void Output::check(const Case&, const CheckContext& at) const {
  check_within_run(at, "times", times, end);
  if (interval <= 0 || end / interval <= most_snapshots) return;
  at.reject(at.key("interval"),
            fmt::format("{} = {:g} s gives {:.3g} snapshots up to {} = {:g} s, and at most {} are written",
                        at.key("interval"), interval, end / interval, at.key("end"), end, most_snapshots),
            fmt::format("give {:.2g} s or more", end / most_snapshots));
}

}  // namespace thalweg
