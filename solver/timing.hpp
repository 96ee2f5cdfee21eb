#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <type_traits>
#include <utility>

namespace thalweg {

/// The headings of the timing report are the lines of the step (step.hpp).
enum class Heading {
  move_walls,
  refresh_neighbours,
  apply_equation_of_state,
  extrapolate_to_walls,
  weigh_sediment,
  update_bed_states,
  apply_rheology,
  compute_accelerations,
  stable_time_step,
  kick,
  solve_viscosity,
  drift,
  compute_density_rates,
  update_density,
  advance_pore_pressure,
  update_rest,
  output,
  count
};

inline constexpr std::array<const char*, static_cast<std::size_t>(Heading::count)> heading_names = {
    "move_walls",
    "refresh_neighbours",
    "apply_equation_of_state",
    "extrapolate_to_walls",
    "weigh_sediment",
    "update_bed_states",
    "apply_rheology",
    "compute_accelerations",
    "stable_time_step",
    "kick",
    "solve_viscosity",
    "drift",
    "compute_density_rates",
    "update_density",
    "advance_pore_pressure",
    "update_rest",
    "output"};

/// Seconds and calls per heading.
class Timing {
 public:
  struct Entry {
    double seconds = 0;
    long calls = 0;
  };

  /// Runs what() and books its time under the heading.
  template <class What>
  decltype(auto) time(Heading heading, const What& what) {
    current_ = heading;
    const Booking booking(entries_[static_cast<std::size_t>(heading)]);
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
  [[nodiscard]] const char* current() const { return heading_names[static_cast<std::size_t>(current_)]; }

  [[nodiscard]] const auto& entries() const { return entries_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Booking {
    Entry& entry;
    Clock::time_point start = Clock::now();
    explicit Booking(Entry& e) : entry(e) {}
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;
    ~Booking() {
      entry.seconds += std::chrono::duration<double>(Clock::now() - start).count();
      ++entry.calls;
    }
  };

  std::array<Entry, static_cast<std::size_t>(Heading::count)> entries_{};
  std::function<void()> finish_;
  Heading current_ = Heading::refresh_neighbours;
};

}  // namespace thalweg
