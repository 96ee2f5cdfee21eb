#include "common/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <thread>

namespace thalweg {
namespace {

/// Makes stderr a terminal while it lives.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    grantpt(master_);
    unlockpt(master_);
    const int terminal = open(ptsname(master_), O_RDWR | O_NOCTTY);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
  }
  ~Terminal() {
    dup2(before_, STDERR_FILENO);
    close(before_);
    close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// The text on it since the last call.
  std::string text() const {
    std::array<char, 1000> part{};
    const ssize_t count = read(master_, part.data(), part.size());
    return {part.data(), static_cast<std::size_t>(count > 0 ? count : 0)};
  }

 private:
  int before_ = dup(STDERR_FILENO);
  int master_;
};

TEST(ProgressLine, IsRewrittenInPlaceOnATerminal) {
  const Terminal terminal;
  ProgressLine line({.width = 10});
  EXPECT_TRUE(line.on_terminal());
  line.show([] { return "too early"; });
  EXPECT_EQ(terminal.text(), "");
  std::this_thread::sleep_for(std::chrono::milliseconds(210));
  line.show([] { return "one"; });
  line.show([] { return "at once"; });
  EXPECT_EQ(terminal.text(), "\rone       ");
  line.write("two");
  line.finish();
  line.finish();
  EXPECT_EQ(terminal.text(), "\rtwo       \r\n");  // a terminal adds the carriage return
}

TEST(ProgressLine, IsALineNowAndThenInALog) {
  testing::internal::CaptureStderr();
  {
    ProgressLine often({.log_pause = std::chrono::milliseconds(0)});
    EXPECT_FALSE(often.on_terminal());
    often.show([] { return "one"; });
    often.show([] { return "two"; });
    ProgressLine seldom({});
    seldom.show([] { return "not before ten seconds"; });
    ProgressLine quiet({.quiet = std::chrono::seconds(2), .log_pause = std::chrono::milliseconds(0)});
    quiet.show([] { return "not before two seconds"; });
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "one\ntwo\n");
}

TEST(ProgressBar, ShowsTheShareDone) {
  EXPECT_EQ(progress_bar(0, '.'), "[..............................]");
  EXPECT_EQ(progress_bar(0.5, ' '), "[###############               ]");
  EXPECT_EQ(progress_bar(1.2, '.'), "[##############################]");
}

}  // namespace
}  // namespace thalweg
