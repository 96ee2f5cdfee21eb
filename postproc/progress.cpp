#include "postproc/progress.hpp"

#include <fmt/format.h>

namespace thalweg {

void SnapshotProgress::show(std::size_t done, double time) {
  line_.show([&] {
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    return fmt::format("snapshots {} {} of {}, t = {:g} s, {:.0f} s", progress_bar(share, '.'), done, total_, time,
                       line_.elapsed());
  });
}

}  // namespace thalweg
