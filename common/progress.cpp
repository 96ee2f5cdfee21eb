#include "common/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/console.hpp"

namespace thalweg {
namespace {

/// The text as wide as it fits into one line of the terminal: a longer one would leave its beginning behind.
std::string fitted(const std::string& text, std::size_t width) {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1)
    width = std::min<std::size_t>(width, size.ws_col - 1U);
  return fmt::format("{:<{}}", text.substr(0, width), width);
}

}  // namespace

ProgressLine::ProgressLine(const ProgressLook& look) : look_(look), terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::write(const std::string& text) {
  last_ = Clock::now();
  if (terminal_) {
    fmt::print(stderr, "\r{}", fitted(text, look_.width));
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
  if (verbosity() == Verbosity::quiet) return false;
  const auto now = Clock::now();
  return now - begun_ >= look_.quiet && now - last_ >= (terminal_ ? terminal_pause : look_.log_pause);
}

std::string duration_text(double seconds) {
  constexpr double minute = 60;
  constexpr double hour = 3600;
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * hour) return fmt::format("{:.1f} min", seconds / minute);
  return fmt::format("{:.1f} h", seconds / hour);
}

std::string progress_text(const ProgressFacts& progress) {
  constexpr std::size_t width = 20;
  const double share = std::clamp(progress.share, 0.0, 1.0);
  const auto done = static_cast<std::size_t>(share * width);
  std::string text = fmt::format("{} [{}{}] {:3.0f} %", progress.what, std::string(done, '#'),
                                 std::string(width - done, ' '), std::floor(100 * share));
  if (!progress.facts.empty()) text += "  " + progress.facts;
  const double gained = share - progress.begun_at;
  if (share < 1 && gained > 0) text += fmt::format(", {} left", duration_text(progress.elapsed * (1 - share) / gained));
  return text;
}

}  // namespace thalweg
