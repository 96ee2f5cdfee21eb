#pragma once

#include <chrono>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace thalweg {

/// Seconds and calls by heading, in the order in which headings first appear: the lines of the step (step.hpp), and
/// what models call their own.
class Timing {
 public:
  struct Entry {
    std::string_view heading;  // a literal
    double seconds = 0;
    long calls = 0;
  };

  /// Runs what() and books its time under the heading, a literal.
  template <class What>
  decltype(auto) time(std::string_view heading, const What& what) {
    current_ = heading;
    Booking booking(*this, number_of(heading));
    if constexpr (std::is_void_v<decltype(what())>) {
      what();
      if (finish_) finish_();
    } else {
      auto result = what();
      if (finish_) finish_();
      return result;
    }
  }

  /// Lets every heading wait for a device that works on its own; without it time is booked where it is waited for.
  void wait_with(std::function<void()> finish) { finish_ = std::move(finish); }
  [[nodiscard]] bool waits() const { return finish_ != nullptr; }
  /// The heading begun last.
  [[nodiscard]] std::string_view current() const { return current_; }

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t number_of(std::string_view heading) {
    for (std::size_t n = 0; n < entries_.size(); ++n) {
      if (entries_[n].heading == heading) return n;
    }
    entries_.push_back({heading});
    return entries_.size() - 1;
  }

  /// Books by number, because entries move when one is added. A heading inside another takes its seconds from it.
  struct Booking {
    Timing& of;
    std::size_t entry;
    Booking* outer;
    double inside = 0;  // [s] of headings within this one
    Clock::time_point start = Clock::now();

    Booking(Timing& timing, std::size_t number) : of(timing), entry(number), outer(timing.open_) { of.open_ = this; }
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;
    ~Booking() {
      const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
      of.entries_[entry].seconds += elapsed - inside;
      ++of.entries_[entry].calls;
      if (outer != nullptr) outer->inside += elapsed;
      of.open_ = outer;
    }
  };

  std::vector<Entry> entries_;
  Booking* open_ = nullptr;
  std::function<void()> finish_;
  std::string_view current_ = "start";
};

}  // namespace thalweg
