#include "postproc/gnuplot.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "postproc/file_actions.hpp"

namespace thalweg {
namespace {

// gnuplot's complaint on one line, without the echo of the script and the caret under it.
std::string complaint_in(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string line;
  std::string last;
  while (std::getline(stream, line)) {
    if (line.find_first_not_of(" ^\t\r") != std::string::npos) last = line;
  }
  return last.empty() ? "no message" : last;
}

}  // namespace

GnuplotResult run_gnuplot(const std::filesystem::path& script) {
  const char* other_program = std::getenv("THALWEG_GNUPLOT");
  std::string program = other_program != nullptr && *other_program != '\0' ? other_program : "gnuplot";
  const std::filesystem::path folder = std::filesystem::absolute(script).parent_path();
  const std::filesystem::path log = folder / (script.stem().string() + ".log");
  std::string script_name = script.filename().string();

  FileActions files;
  posix_spawn_file_actions_addchdir_np(&files.actions, folder.c_str());
  posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files.actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files.actions, STDOUT_FILENO, STDERR_FILENO);
  const std::array<char*, 3> arguments{program.data(), script_name.data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, program.c_str(), &files.actions, nullptr, arguments.data(), environ);
  std::error_code ignored;
  if (failure == ENOENT) {
    std::filesystem::remove(log, ignored);
    return GnuplotResult::not_installed;
  }
  if (failure != 0) {
    throw RunError(script.string() + ": " + program + " cannot be started: " + std::strerror(failure) +
                   "; check the installation of gnuplot-nox");
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw RunError(script.string() + ": " + program + " failed: " + complaint_in(log) + "; its output is in " +
                   log.string());
  }
  std::filesystem::remove(log, ignored);
  return GnuplotResult::drawn;
}

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace thalweg
