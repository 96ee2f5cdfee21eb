#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace thalweg {

/// Looks of a progress line.
struct ProgressLook {
  std::size_t width = 80;                       // [characters] that it fills on a terminal, so that no older text shows
  std::chrono::milliseconds quiet{0};           // from the start, in which nothing is shown
  std::chrono::milliseconds log_pause{10'000};  // between two lines where stderr is no terminal
};

/// The line on stderr that tells how far a long computation is. On a terminal it is rewritten in place, five times a
/// second at most; elsewhere, as in the log of a batch job, it is a new line now and then.
class ProgressLine {
 public:
  explicit ProgressLine(const ProgressLook& look);
  ~ProgressLine() { finish(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the text that `make_text()` returns, which is called only if the line is due.
  template <class MakeText>
  void show(const MakeText& make_text) {
    if (is_due()) write(make_text());
  }
  /// Shows a text at once, due or not.
  void write(const std::string& text);
  /// Ends the line on a terminal, so that the text after it begins on a line of its own.
  void finish();

  [[nodiscard]] bool on_terminal() const { return terminal_; }
  [[nodiscard]] bool is_shown() const { return shown_; }  // on a terminal, and not finished
  [[nodiscard]] double elapsed() const;                   // [s] since the start

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due() const;

  ProgressLook look_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
};

/// The progress of a computation, for the text that all programs show.
struct ProgressFacts {
  std::string what{};   // "solver"
  double share = 0;     // done, from 0 to 1
  double begun_at = 0;  // share with which this program began
  double elapsed = 0;   // [s] since then
  std::string facts{};  // the program's own figures
};

/// "solver [########            ]  40 %  t = 0.2 of 0.5 s, …, 12 s left".
std::string progress_text(const ProgressFacts& progress);

/// "12 s", "3.5 min", "2.1 h".
std::string duration_text(double seconds);

}  // namespace thalweg
