#include "common/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <thread>

#include "common/console.hpp"

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

// A quarter of what this program has to do (from 0.2 to 1) is done in 30 s: three times as long is left.
TEST(ProgressText, ShowsTheShareDoneAndTheTimeLeft) {
  EXPECT_EQ(progress_text({.what = "solver", .share = 0.4, .begun_at = 0.2, .elapsed = 30, .facts = "t = 2 s"}),
            "solver [########            ]  40 %  t = 2 s, 90 s left");
  EXPECT_EQ(progress_text({.what = "gencase", .share = 0}), "gencase [                    ]   0 %");
  EXPECT_EQ(progress_text({.what = "foam", .share = 1.2}), "foam [####################] 100 %");
}

TEST(ProgressText, GivesDurationsInTheUnitThatIsRead) {
  EXPECT_EQ(duration_text(12.4), "12 s");
  EXPECT_EQ(duration_text(210), "3.5 min");
  EXPECT_EQ(duration_text(7560), "2.1 h");
}

TEST(ProgressLine, IsSilentWhenTheUserWantsQuiet) {
  const Terminal terminal;
  ProgressLine line({.width = 10});
  std::this_thread::sleep_for(std::chrono::milliseconds(210));
  set_verbosity(Verbosity::quiet);
  line.show([] { return "one"; });
  set_verbosity(Verbosity::normal);
  EXPECT_EQ(terminal.text(), "");
}

}  // namespace
}  // namespace thalweg
