#include "postproc/progress.hpp"

#include <fmt/format.h>

namespace thalweg {

void SnapshotProgress::show(std::size_t done, double time) {
  line_.show([&] {
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    return progress_text({.what = "postproc",
                          .share = share,
                          .elapsed = line_.elapsed(),
                          .facts = fmt::format("snapshot {} of {}, t = {:g} s", done, total_, time)});
  });
}

}  // namespace thalweg
