#pragma once

#include <cstddef>

#include "common/progress.hpp"

namespace thalweg {

/// Shows how many snapshots are done.
class SnapshotProgress {
 public:
  explicit SnapshotProgress(std::size_t total) : total_(total) {}

  /// `done` snapshots, the last one of `time` [s].
  void show(std::size_t done, double time);
  /// Ends the line, so that the text after it begins on a line of its own.
  void finish() { line_.finish(); }

 private:
  std::size_t total_;
  ProgressLine line_{{.width = 90, .quiet = std::chrono::seconds(2)}};
};

}  // namespace thalweg
