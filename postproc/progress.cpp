#include "postproc/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace thalweg {

SnapshotProgress::SnapshotProgress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

void SnapshotProgress::show(std::size_t done, double time) {
  const auto now = Clock::now();
  const std::chrono::duration<double> elapsed = now - begun_;
  const std::chrono::duration<double> pause(terminal_ ? 0.2 : 10);
  if (elapsed < std::chrono::seconds(2) || now - last_ < pause) return;
  last_ = now;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / total_;
  const std::string line = fmt::format("snapshots [{:#<{}}{:.<{}}] {} of {}, t = {:g} s, {:.0f} s", "", filled, "",
                                       width - filled, done, total_, time, elapsed.count());
  if (terminal_) {
    fmt::print(stderr, "\r{:<90}", line);
    shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

void SnapshotProgress::finish() {
  if (shown_) fmt::print(stderr, "\n");
  shown_ = false;
}

}  // namespace thalweg
