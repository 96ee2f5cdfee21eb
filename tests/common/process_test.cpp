#include "common/process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
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

/// True if the process has ended within some seconds; one that nobody has waited for yet has.
bool has_ended(pid_t process) {
  for (int i = 0; i < 250; ++i) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string words;
    if (!std::getline(stat, words) || words.find(") Z ") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

// kill -9 leaves a program no time to end its children.
TEST_F(Process, OutlivesNoParentThatIsKilled) {
  for (const bool own_group : {false, true}) {
    const pid_t parent = fork();
    if (parent == 0) {
      ChildProcess child(shell(own_group ? "sleep 60 & echo $! > started; echo $$ > part; mv part all; wait"
                                         : "echo $$ > started; echo $$ > part; mv part all; exec sleep 60"),
                         {.folder = folder, .own_group = own_group});
      child.wait();
      _exit(1);
    }
    wait_for("all");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const pid_t program = std::stoi(text_of("all"));
    const pid_t started = std::stoi(text_of("started"));
    ASSERT_EQ(kill(started, 0), 0);
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    EXPECT_TRUE(has_ended(program)) << "group " << own_group;
    EXPECT_TRUE(has_ended(started)) << "group " << own_group;
    fs::remove(folder / "all");
  }
}

TEST_F(Process, OfAGroupTellsHowItEndedAndClosesItsPipe) {
  ChildProcess child(shell("echo one >&3; exec 3>&-; sleep 0.05; exit 3"), {.own_group = true, .piped = 3});
  EXPECT_EQ(child.read_line(), "one");
  EXPECT_EQ(child.read_line(), std::nullopt);
  EXPECT_EQ(child.wait(), 3);
  EXPECT_EQ(ChildProcess(shell("kill -KILL $$"), {.own_group = true}).wait(), 128 + SIGKILL);
  EXPECT_EQ(ChildProcess(shell("kill -SEGV $$"), {.own_group = true}).wait(), 128 + SIGSEGV);
}

TEST_F(Process, SaysWhyAProgramCannotBeStarted) {
  std::ofstream(folder / "text") << "no program\n";
  for (const bool own_group : {false, true}) {
    EXPECT_THROW(ChildProcess({(folder / "text").string()}, {.own_group = own_group}), StartError);
    EXPECT_THROW(ChildProcess({"sh"}, {.folder = folder / "absent", .own_group = own_group}), StartError);
  }
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
