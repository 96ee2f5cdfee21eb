#include "common/console.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

class ConsoleTest : public ::testing::Test {
 protected:
  ConsoleTest() : run_{fs::path(::testing::TempDir()) / "console"} {
    fs::remove_all(run_.root);
    fs::create_directories(run_.root);
  }
  ~ConsoleTest() override { set_verbosity(Verbosity::normal); }
  ConsoleTest(const ConsoleTest&) = delete;
  ConsoleTest& operator=(const ConsoleTest&) = delete;

  /// stdout and stderr of one line of each kind.
  static std::pair<std::string, std::string> shown_with(Verbosity verbosity) {
    set_verbosity(verbosity);
    CaptureStdout();
    CaptureStderr();
    say("result");
    say_detail("detail");
    warn("danger");
    std::string out = GetCapturedStdout();
    return {out, GetCapturedStderr()};
  }
  [[nodiscard]] std::string log() const {
    std::ostringstream text;
    text << std::ifstream(run_.log()).rdbuf();
    return text.str();
  }

  RunFolder run_;
};

TEST_F(ConsoleTest, ShowsWhatTheUserWants) {
  EXPECT_THAT(shown_with(Verbosity::normal), testing::Pair("result\n", "warning: danger\n"));
  EXPECT_THAT(shown_with(Verbosity::quiet), testing::Pair("", "warning: danger\n"));
  EXPECT_THAT(shown_with(Verbosity::verbose), testing::Pair("result\n", "detail\nwarning: danger\n"));
}

// A batch job's user finds there what the terminal did not show.
TEST_F(ConsoleTest, KeepsAllOfItInTheRunsFolder) {
  keep_log(run_, "solver");
  (void)shown_with(Verbosity::quiet);
  say("two\nlines");
  EXPECT_THAT(log(), HasSubstr(" solver start: "));
  EXPECT_THAT(log(), HasSubstr(" solver info: result\n"));
  EXPECT_THAT(log(), HasSubstr(" solver detail: detail\n"));
  EXPECT_THAT(log(), HasSubstr(" solver warning: danger\n"));
  EXPECT_THAT(log(), HasSubstr(" solver info: lines\n"));
  const std::string before = log();
  keep_log(run_, "postproc");
  say("more");
  EXPECT_THAT(log(), testing::StartsWith(before)) << "programs add to it";
  forget_log(run_);
  EXPECT_FALSE(fs::exists(run_.log()));
}

TEST_F(ConsoleTest, GoesOnWhereNoLogCanBeWritten) {
  keep_log({run_.root / "absent" / "folder"}, "solver");
  CaptureStdout();
  say("result");
  EXPECT_EQ(GetCapturedStdout(), "result\n");
}

TEST_F(ConsoleTest, FindsTheErrorsOfTheLastStart) {
  keep_log(run_, "solver");
  log_line("error", "old; mend it");
  keep_log(run_, "solver");
  log_line("info", "an error: no");
  log_line("error", "case.toml:12: wrong: value; write another");
  EXPECT_THAT(errors_in_log(run_), ElementsAre("case.toml:12: wrong: value; write another"));
  const auto error = nlohmann::json::parse(error_json(errors_in_log(run_).front()));
  EXPECT_EQ(error["file"], "case.toml");
  EXPECT_EQ(error["line"], 12);
  EXPECT_EQ(error["cure"], "write another");
  EXPECT_THAT(error_json("no place; a cure"), Not(HasSubstr("line")));
}

}  // namespace
}  // namespace thalweg
