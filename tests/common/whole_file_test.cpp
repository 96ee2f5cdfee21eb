#include "common/whole_file.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "common/error.hpp"

// The linker leads these calls of the library here (-Wl,--wrap), so that a test sees their order.
namespace {
std::vector<std::string> calls;
}
extern "C" {
int __real_fsync(int descriptor);
int __real_rename(const char* from, const char* to);
int __wrap_fsync(int descriptor) {
  struct stat status {};
  fstat(descriptor, &status);
  calls.emplace_back(S_ISDIR(status.st_mode) ? "sync folder" : "sync file");
  return __real_fsync(descriptor);
}
int __wrap_rename(const char* from, const char* to) {
  calls.push_back("rename to " + std::filesystem::path(to).filename().string());
  return __real_rename(from, to);
}
}

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class WholeFileTest : public ::testing::Test {
 protected:
  WholeFileTest() {
    fs::remove_all(folder);
    fs::create_directories(folder);
    calls.clear();
  }
  ~WholeFileTest() override { fs::remove_all(folder); }
  WholeFileTest(const WholeFileTest&) = delete;
  WholeFileTest& operator=(const WholeFileTest&) = delete;

  static std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }

  const fs::path folder =
      fs::path(::testing::TempDir()) / ("whole_file_" + std::to_string(getpid()));  // tests run beside each other
};

// A name on the disk without its contents is what a power cut leaves of a file that is renamed first.
TEST_F(WholeFileTest, IsOnTheDiskBeforeItHasItsName) {
  write_whole_bytes(folder / "a.vtp", "contents");
  EXPECT_THAT(calls, ElementsAre("sync file", "rename to a.vtp", "sync folder"));
}

TEST_F(WholeFileTest, BringsNewFoldersToTheDiskToo) {
  write_whole_bytes(folder / "one" / "two" / "a.csv", "contents");
  EXPECT_THAT(calls, ElementsAre("sync folder", "sync folder", "sync file", "rename to a.csv", "sync folder"));
}

TEST_F(WholeFileTest, KeepsTheFileBefore) {
  const WholeFile how{.previous = folder / "old"};
  write_whole_bytes(folder / "new", "1", how);
  EXPECT_THAT(names(), ElementsAre("new"));
  write_whole_bytes(folder / "new", "2", how);
  write_whole_bytes(folder / "new", "3", how);
  EXPECT_EQ(text_of(folder / "new"), "3");
  EXPECT_EQ(text_of(folder / "old"), "2");
  EXPECT_THAT(names(), ElementsAre("new", "old"));
}

// A limit on the size of files stands for a full disk: the write fails in the middle.
TEST_F(WholeFileTest, ChangesNothingWhereThereIsNoRoom) {
  write_whole_bytes(folder / "a", "before");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  try {
    write_whole_text(folder / "a", [](std::ostream& to) { to << std::string(5000, 'x'); }, {.previous = folder / "b"});
  } catch (const RunError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(message, HasSubstr("a: cannot be written: File too large; "));
  EXPECT_EQ(text_of(folder / "a"), "before");
  EXPECT_THAT(names(), ElementsAre("a"));
}

TEST_F(WholeFileTest, DoesNotMakeAFolderThatIsGone) {
  const fs::path gone = folder / "gone" / "a";
  EXPECT_THROW(write_whole_bytes(gone, "contents", {.make_folders = false}), RunError);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(WholeFileTest, RemovesPartsOfDeadProgramsOnly) {
  const pid_t dead = fork();
  if (dead == 0) _exit(0);
  waitpid(dead, nullptr, 0);
  const std::string theirs = ".s00001." + std::to_string(dead) + ".part.vtp";
  const std::string ours = ".s00001." + std::to_string(getpid()) + ".part.vtp";
  fs::create_directories(folder / "snapshots");
  std::ofstream(folder / "snapshots" / theirs) << "cut";
  std::ofstream(folder / "snapshots" / ours) << "growing";
  std::ofstream(folder / "parts.part.csv") << "a user's";
  remove_dead_parts(folder);
  EXPECT_FALSE(fs::exists(folder / "snapshots" / theirs));
  EXPECT_TRUE(fs::exists(folder / "snapshots" / ours));
  EXPECT_TRUE(fs::exists(folder / "parts.part.csv"));
}

}  // namespace
}  // namespace thalweg
