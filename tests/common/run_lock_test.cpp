#include "common/run_lock.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunLockTest : public ::testing::Test {
 protected:
  RunLockTest() { fs::remove_all(folder); }
  ~RunLockTest() override { fs::remove_all(folder); }
  RunLockTest(const RunLockTest&) = delete;
  RunLockTest& operator=(const RunLockTest&) = delete;

  const fs::path folder = fs::path(::testing::TempDir()) / ("run_lock_" + std::to_string(getpid()));
};

TEST_F(RunLockTest, ASecondProgramIsToldWhoIsThere) {
  const RunLock first(folder, "thalweg-solver");
  try {
    const RunLock second(folder, "thalweg-gencase");
    FAIL() << "two programs hold one lock";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("thalweg-solver, process " + std::to_string(getpid()) + " on "));
    EXPECT_THAT(error.what(), HasSubstr("; wait for it, stop it, or choose another folder"));
  }
}

TEST_F(RunLockTest, EndsWithItsProgramInWhateverWay) {
  const pid_t killed = fork();
  if (killed == 0) {
    const RunLock lock(folder, "thalweg-solver");
    kill(getpid(), SIGKILL);
  }
  waitpid(killed, nullptr, 0);
  EXPECT_NO_THROW(RunLock(folder, "thalweg-solver"));
}

TEST_F(RunLockTest, NoticesAFolderThatIsMovedOrExchanged) {
  const RunLock lock(folder, "thalweg-solver");
  EXPECT_NO_THROW(lock.require_folder());
  const fs::path moved = folder.string() + "_moved";
  fs::rename(folder, moved);
  EXPECT_THROW(lock.require_folder(), RunError);
  const RunLock of_another(folder, "thalweg-solver");
  EXPECT_THROW(lock.require_folder(), RunError);
  fs::remove_all(moved);
}

}  // namespace
}  // namespace thalweg
