#include "common/process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace thalweg {
namespace {

namespace fs = std::filesystem;

class Process : public ::testing::Test {
 protected:
  Process() {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Process() override { fs::remove_all(folder); }

  static std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder / name).rdbuf();
    return text.str();
  }
  void wait_for(const std::string& name) const {
    while (!fs::exists(folder / name)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }

  const fs::path folder = fs::path(::testing::TempDir()) /
                          (std::string("process ") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Process, TellsHowAChildEnded) {
  EXPECT_EQ(ChildProcess(shell("exit 0")).wait(), 0);
  EXPECT_EQ(ChildProcess(shell("exit 3")).wait(), 3);
  EXPECT_EQ(ChildProcess(shell("kill -KILL $$")).wait(), 128 + SIGKILL);
}

TEST_F(Process, WritesBothOutputsToTheLogAndReadsNothing) {
  EXPECT_EQ(ChildProcess(shell("cat; echo out; echo err >&2"), {.log = folder / "log"}).wait(), 0);
  EXPECT_EQ(text_of("log"), "out\nerr\n");
  EXPECT_THROW(ChildProcess(shell("exit 0"), {.log = folder / "absent/log"}), RunError);
}

TEST_F(Process, RunsInTheFolder) {
  EXPECT_EQ(ChildProcess(shell("echo here > place"), {.folder = folder}).wait(), 0);
  EXPECT_EQ(text_of("place"), "here\n");
}

TEST_F(Process, NamesAProgramThatIsAbsent) {
  try {
    const ChildProcess child({"thalweg-no-such-program"});
    FAIL() << "it was started";
  } catch (const StartError& error) {
    EXPECT_TRUE(error.not_found());
    EXPECT_STREQ(error.what(),
                 "thalweg-no-such-program: cannot be started: No such file or directory; install or build it again");
  }
  EXPECT_TRUE(on_path("sh"));
  EXPECT_FALSE(on_path("thalweg-no-such-program"));
}

TEST_F(Process, ReadsLinesFromThePipeUntilTheChildClosesIt) {
  ChildProcess child(shell("echo one; echo two >&3; echo three >&3; printf rest >&3"),
                     {.log = "/dev/null", .piped = 3});
  EXPECT_EQ(child.read_line(), "two");
  EXPECT_EQ(child.read_line(), "three");
  EXPECT_EQ(child.read_line(), std::nullopt);
  EXPECT_EQ(child.wait(), 0);
}

TEST_F(Process, LosesItsPatienceWithAChildThatSaysNothing) {
  ChildProcess child({"sleep", "60"}, {.piped = 1});
  EXPECT_EQ(child.read_line(std::chrono::milliseconds(20)), std::nullopt);
  EXPECT_TRUE(child.running());
  child.end();
  EXPECT_FALSE(child.running());
  EXPECT_EQ(child.wait(), 128 + SIGTERM);
}

TEST_F(Process, CountsTheTimeOfThePrograms) {
  ChildProcess child(shell("i=0; while [ $i -lt 100000 ]; do i=$((i + 1)); done"));
  EXPECT_EQ(child.wait(), 0);
  EXPECT_GT(child.cpu_seconds(), 0);
}

TEST_F(Process, EndsWithAllThatItStarted) {
  pid_t grandchild = 0;
  {
    ChildProcess child(shell("sleep 60 & echo $! >&3; wait"), {.log = "/dev/null", .own_group = true, .piped = 3});
    grandchild = std::stoi(child.read_line().value());
    ASSERT_EQ(kill(grandchild, 0), 0);
  }
  // Once its parent is gone it is reaped elsewhere, which takes a moment.
  for (int i = 0; i < 100 && kill(grandchild, 0) == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_NE(kill(grandchild, 0), 0);
}

// The signals of a terminal and of a batch system: the child decides how it ends.
TEST_F(Process, PassesTerminationOnAndLeavesInterruptsToTheForeground) {
  const std::string file = (folder / "started").string();
  std::thread stop([&] {
    wait_for("started");
    std::raise(SIGINT);  // to this program alone: it neither ends nor passes it on
    kill(getpid(), SIGTERM);
  });
  const int status = run_in_foreground(
      shell("trap 'exit 7' TERM; trap 'exit 8' INT; touch '" + file + "'; while :; do sleep 0.01; done"));
  stop.join();
  EXPECT_EQ(status, 7);
}

TEST_F(Process, RemembersSignalsWhileItWatches) {
  const SignalWatch watch;
  EXPECT_EQ(SignalWatch::received(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(SignalWatch::received(), SIGTERM);
}

}  // namespace
}  // namespace thalweg
