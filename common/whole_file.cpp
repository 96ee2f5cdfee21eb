#include "common/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_mark = ".part";

[[noreturn]] void fail(const fs::path& file, int cause) {
  const char* cure = "check the folder's permissions and free space";
  if (cause == ENOENT || cause == ENOTDIR) cure = "its folder is gone: moved or deleted while the program ran";
  if (cause == ENAMETOOLONG) cure = "give a folder with a shorter path";
  if (cause == EFBIG) cure = "raise the limit on the size of files (ulimit -f)";
  throw RunError(fmt::format("{}: cannot be written: {}; {}", file.string(), std::strerror(cause), cure));
}

/// Removes the temporary file unless it has been renamed.
struct Temporary {
  fs::path path;
  ~Temporary() {
    if (!path.empty()) unlink(path.c_str());
  }
};

/// A descriptor that is closed at the end.
struct Opened {
  int descriptor;
  ~Opened() {
    if (descriptor >= 0) close(descriptor);
  }
};

/// Waits until a file or folder is on the disk. File systems that cannot do so for folders say EINVAL or ENOTSUP.
void sync(const fs::path& what, const fs::path& file) {
  const Opened opened{open(what.c_str(), O_RDONLY | O_CLOEXEC)};
  if (opened.descriptor < 0) fail(file, errno);
  if (fsync(opened.descriptor) != 0 && errno != EINVAL && errno != ENOTSUP) fail(file, errno);
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Makes the folders that are missing, and brings their entries to the disk.
void make_folders(const fs::path& folder, const fs::path& file) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, ignored); at = at.parent_path()) missing.push_back(at);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) fail(file, failure.value());
  for (const fs::path& made : missing) sync(folder_of(made), file);
}

/// Gives what stands at `file` the name `previous` too. A hard link leaves `file` in place; where there are none the
/// file is renamed, and for a moment only `previous` is there.
void keep(const fs::path& file, const fs::path& previous) {
  const Temporary second{previous.string() + fmt::format(".{}{}", getpid(), part_mark)};
  unlink(second.path.c_str());
  if (link(file.c_str(), second.path.c_str()) == 0) {
    if (rename(second.path.c_str(), previous.c_str()) != 0) fail(previous, errno);
  } else if (errno != ENOENT && rename(file.c_str(), previous.c_str()) != 0) {
    fail(previous, errno);
  }
}

void write_all(const fs::path& temporary, std::string_view bytes, const fs::path& file) {
  const Opened opened{open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (opened.descriptor < 0) fail(file, errno);
  while (!bytes.empty()) {
    const ssize_t written = write(opened.descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// The number of the process that a temporary file belongs to, by its name; nothing for other files.
std::optional<pid_t> owner_of_part(const std::string& name) {
  const auto mark = name.rfind(part_mark);
  if (mark == std::string::npos || mark == 0) return std::nullopt;
  const auto dot = name.rfind('.', mark - 1);
  if (dot == std::string::npos) return std::nullopt;
  pid_t owner = 0;
  const auto parsed = std::from_chars(name.data() + dot + 1, name.data() + mark, owner);
  if (parsed.ec != std::errc{} || parsed.ptr != name.data() + mark || owner <= 0) return std::nullopt;
  return owner;
}

}  // namespace

void write_whole_file(const fs::path& file, const std::function<void(const fs::path&)>& write, const WholeFile& how) {
  const fs::path folder = folder_of(file);
  if (how.make_folders) make_folders(folder, file);
  // The process number keeps the files of two runs in one folder apart. The extension stays, because writers read it.
  const std::string name =
      fmt::format(".{}.{}{}{}", file.stem().string(), getpid(), part_mark, file.extension().string());
  Temporary temporary{file.parent_path() / name};
  write(temporary.path);
  sync(temporary.path, file);
  if (!how.previous.empty()) keep(file, how.previous);
  if (rename(temporary.path.c_str(), file.c_str()) != 0) fail(file, errno);
  temporary.path.clear();
  sync(folder, file);
}

void write_whole_bytes(const fs::path& file, std::string_view bytes, const WholeFile& how) {
  write_whole_file(
      file, [&](const fs::path& temporary) { write_all(temporary, bytes, file); }, how);
}

void write_whole_text(const fs::path& file, const std::function<void(std::ostream&)>& write, const WholeFile& how) {
  std::ostringstream text;
  write(text);
  write_whole_bytes(file, text.view(), how);
}

void sync_file(const fs::path& file) { sync(file, file); }

void remove_dead_parts(const fs::path& folder) {
  std::error_code ignored;
  for (auto at = fs::recursive_directory_iterator(folder, ignored); at != fs::recursive_directory_iterator();
       at.increment(ignored)) {
    const auto owner = owner_of_part(at->path().filename().string());
    if (!owner || !at->is_regular_file(ignored)) continue;
    if (kill(*owner, 0) != 0 && errno == ESRCH) unlink(at->path().c_str());
  }
}

}  // namespace thalweg
