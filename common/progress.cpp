#include "common/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace thalweg {

ProgressLine::ProgressLine(const ProgressLook& look) : look_(look), terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::write(const std::string& text) {
  last_ = Clock::now();
  if (terminal_) {
    fmt::print(stderr, "\r{:<{}}", text, look_.width);
    shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
}

void ProgressLine::finish() {
  if (shown_) fmt::print(stderr, "\n");
  shown_ = false;
}

double ProgressLine::elapsed() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

bool ProgressLine::is_due() const {
  constexpr std::chrono::milliseconds terminal_pause(200);
  const auto now = Clock::now();
  return now - begun_ >= look_.quiet && now - last_ >= (terminal_ ? terminal_pause : look_.log_pause);
}

std::string progress_bar(double share, char rest) {
  constexpr std::size_t width = 30;
  const auto done = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * width);
  return "[" + std::string(done, '#') + std::string(width - done, rest) + "]";
}

}  // namespace thalweg
