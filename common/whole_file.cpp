#include "common/whole_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Removes the temporary file unless it has been renamed.
struct Temporary {
  fs::path path;
  ~Temporary() {
    std::error_code ignored;
    if (!path.empty()) fs::remove(path, ignored);
  }
};

[[noreturn]] void fail(const fs::path& file, const std::string& cause) {
  throw RunError(file.string() + ": cannot be written: " + cause + "; check the folder's permissions and free space");
}

}  // namespace

void write_whole_file(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  std::error_code failure;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), failure);
  if (failure) fail(file, failure.message());

  // The process number keeps the files of two runs in one folder apart. The extension stays, because writers read it.
  const std::string name = fmt::format(".{}.{}.part{}", file.stem().string(), getpid(), file.extension().string());
  Temporary temporary{file.parent_path() / name};
  write(temporary.path);
  fs::rename(temporary.path, file, failure);
  if (failure) fail(file, failure.message());
  temporary.path.clear();
}

void write_whole_text(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  write_whole_file(file, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    if (stream) write(stream);
    stream.close();
    if (!stream) fail(file, errno != 0 ? std::strerror(errno) : "the stream failed");
  });
}

}  // namespace thalweg
