#pragma once

#include <future>
#include <utility>

namespace thalweg {

/// One piece of work that goes on beside the caller's.
class BackgroundTask {
 public:
  /// Starts work() once the piece before it is done; rethrows what that one threw.
  template <class Work>
  void start(Work&& work) {
    wait();
    running_ = std::async(std::launch::async, std::forward<Work>(work));
  }
  /// Until it is done; rethrows what it threw.
  void wait() {
    if (running_.valid()) running_.get();
  }

 private:
  std::future<void> running_;  // its destructor waits too
};

}  // namespace thalweg
