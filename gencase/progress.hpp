#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

#include "common/progress.hpp"

namespace thalweg::gencase {

/// Counts the work of a long filling and shows on a terminal how far it is. A log gets nothing.
class Progress {
 public:
  explicit Progress(bool visible = false) : visible_(visible && line_.on_terminal()) {}

  /// Begins a stage of `total` units of work.
  void stage(std::string name, std::int64_t total);
  /// Reports work done; from any thread.
  void add(std::int64_t units);
  /// Shows all work as done, if anything was shown.
  void finish();

 private:
  ProgressLine line_{{.width = 80, .quiet = std::chrono::seconds(2)}};
  bool visible_;
  std::string name_;
  std::int64_t total_ = 1;
  std::atomic<std::int64_t> done_ = 0;
  std::mutex drawing_;
};

}  // namespace thalweg::gencase
