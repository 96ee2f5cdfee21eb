#include "common/memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// A machine's files, made up.
class AvailableMemory : public testing::Test {
 protected:
  AvailableMemory() : root_(fs::path(testing::TempDir()) / ("memory_" + std::to_string(getpid()))) {
    write("proc/meminfo", "MemTotal:       32000000 kB\nMemFree:         1000000 kB\nMemAvailable:   20000000 kB\n");
  }
  ~AvailableMemory() override { fs::remove_all(root_); }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  [[nodiscard]] double found() const { return available_memory(root_); }

 private:
  fs::path root_;
};

TEST_F(AvailableMemory, IsWhatTheKernelSaysWithoutGroups) { EXPECT_EQ(found(), 20000000.0 * 1024); }

TEST_F(AvailableMemory, IsWhatTheLowestGroupOfVersion2Leaves) {
  write("proc/self/cgroup", "0::/slice/job\n");
  write("sys/fs/cgroup/slice/job/memory.max", "max\n");
  write("sys/fs/cgroup/slice/job/memory.current", "5000000\n");
  EXPECT_EQ(found(), 20000000.0 * 1024) << "no limit";
  write("sys/fs/cgroup/slice/memory.max", "8000000000\n");
  write("sys/fs/cgroup/slice/memory.current", "3000000000\n");
  write("sys/fs/cgroup/slice/memory.stat", "anon 1\ninactive_file 500000000\nfile 9\n");
  EXPECT_EQ(found(), 5.5e9) << "a limit around it, less what is used but can be dropped";
  write("sys/fs/cgroup/slice/job/memory.max", "4000000\n");
  EXPECT_EQ(found(), 0) << "more used than allowed";
}

TEST_F(AvailableMemory, IsWhatTheGroupOfVersion1Leaves) {
  write("proc/self/cgroup", "5:devices:/job\n4:memory:/job\n0::/\n");
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "2000000000\n");
  write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1500000000\n");
  EXPECT_EQ(found(), 5e8);
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(found(), 20000000.0 * 1024) << "that is how version 1 writes no limit";
}

TEST(AvailableMemoryHere, IsPartOfTheMachines) {
  const double physical = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  EXPECT_GT(available_memory(), 0);
  EXPECT_LT(available_memory(), physical);
}

}  // namespace
}  // namespace thalweg
