#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace thalweg::gencase {

/// Tells how far a long computation is. Nothing is shown during the first two seconds.
class Progress {
 public:
  /// `show(what, share)` draws: what is being done, and its share done from 0 to 1.
  using Show = std::function<void(const std::string&, double)>;
  explicit Progress(Show show = {}) : show_(std::move(show)) {}

  /// Begins a stage of `total` units of work.
  void stage(std::string what, std::int64_t total);
  /// Reports work done; from any thread.
  void add(std::int64_t units);
  /// Draws the last stage as done, if anything was drawn.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  Show show_;
  std::string what_;
  std::int64_t total_ = 1;
  std::atomic<std::int64_t> done_ = 0;
  std::mutex drawing_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  bool drawn_ = false;
};

}  // namespace thalweg::gencase
