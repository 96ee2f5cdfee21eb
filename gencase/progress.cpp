#include "gencase/progress.hpp"

#include <algorithm>

namespace thalweg::gencase {
namespace {

std::string text_of(const std::string& name, double share) {
  return progress_text({.what = "gencase", .share = share, .facts = name});
}

}  // namespace

void Progress::stage(std::string name, std::int64_t total) {
  name_ = std::move(name);
  total_ = std::max<std::int64_t>(total, 1);
  done_ = 0;
}

void Progress::add(std::int64_t units) {
  const std::int64_t done = done_ += units;
  if (!visible_) return;
  const std::unique_lock lock(drawing_, std::try_to_lock);
  if (!lock) return;  // another thread draws
  line_.show([&] { return text_of(name_, static_cast<double>(done) / static_cast<double>(total_)); });
}

void Progress::finish() {
  if (!line_.is_shown()) return;
  line_.write(text_of("done", 1));
  line_.finish();
}

}  // namespace thalweg::gencase
