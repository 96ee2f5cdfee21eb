#pragma once

#include <chrono>
#include <cstddef>

namespace thalweg {

/// The line that tells how many snapshots are done: on a terminal one line that is rewritten, elsewhere a line now and
/// then; nothing during the first two seconds.
class SnapshotProgress {
 public:
  explicit SnapshotProgress(std::size_t total);

  /// `done` snapshots, the last one of `time` [s].
  void show(std::size_t done, double time);
  /// Ends the line on a terminal, so that what follows starts on its own.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t total_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
};

}  // namespace thalweg
