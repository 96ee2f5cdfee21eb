#include "gencase/progress.hpp"

#include <algorithm>

namespace thalweg::gencase {

void Progress::stage(std::string what, std::int64_t total) {
  what_ = std::move(what);
  total_ = std::max<std::int64_t>(total, 1);
  done_ = 0;
}

void Progress::add(std::int64_t units) {
  const std::int64_t done = done_ += units;
  if (!show_) return;
  const std::unique_lock lock(drawing_, std::try_to_lock);
  if (!lock) return;  // another thread draws
  const auto now = Clock::now();
  if (now - begin_ < std::chrono::seconds(2) || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  drawn_ = true;
  show_(what_, static_cast<double>(done) / static_cast<double>(total_));
}

void Progress::finish() {
  if (drawn_) show_("done", 1);
}

}  // namespace thalweg::gencase
