#include "common/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "common/error.hpp"
#include "common/run_folder.hpp"

namespace thalweg {
namespace {

/// The program that holds the lock, as it has written into the file.
std::string holder(int descriptor) {
  std::array<char, 200> text{};
  const ssize_t length = pread(descriptor, text.data(), text.size(), 0);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "another program";
}

std::string this_program(const std::string& name) {
  std::array<char, 100> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("{}, process {} on {}", name, getpid(), host.data());
}

}  // namespace

RunLock::RunLock(std::filesystem::path folder, const std::string& program) : folder_(std::move(folder)) {
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  const auto file = RunFolder{folder_}.lock();
  if (!failure) descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw InputError(fmt::format("{}: cannot be written: {}; check the folder's permissions and free space",
                                 folder_.string(), failure ? failure.message() : std::strerror(errno)));
  }
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int cause = errno;
    const std::string other = cause == EWOULDBLOCK ? holder(descriptor_) : "";
    if (cause == EWOULDBLOCK) close(descriptor_);
    if (cause == EWOULDBLOCK) {
      throw InputError(fmt::format("{}: {} is at work there; wait for it, stop it, or choose another folder",
                                   folder_.string(), other));
    }
    fmt::print(stderr, "warning: {}: the file system has no locks ({}); let no second program write there\n",
               folder_.string(), std::strerror(cause));
  }
  // The text is for people; without it the lock is as good.
  const std::string text = this_program(program);
  if (ftruncate(descriptor_, 0) == 0) static_cast<void>(pwrite(descriptor_, text.data(), text.size(), 0) < 0);
}

RunLock::~RunLock() { close(descriptor_); }

void RunLock::require_folder() const {
  struct stat held {};
  struct stat there {};
  const auto file = RunFolder{folder_}.lock();
  if (fstat(descriptor_, &held) == 0 && stat(file.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
      held.st_ino == there.st_ino) {
    return;
  }
  throw RunError(fmt::format(
      "{}: the folder of the run was moved, deleted or exchanged while it ran; what was written lies where it went: "
      "continue there with --restart latest",
      folder_.string()));
}

}  // namespace thalweg
