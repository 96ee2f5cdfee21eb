#include "postproc/display.hpp"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "postproc/file_actions.hpp"

namespace thalweg {
namespace {

bool reachable() {
  ::Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

// Starts a program found on the path; 0 when it cannot be.
pid_t start(const std::vector<std::string>& command, const FileActions& files) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  return posix_spawnp(&child, arguments.front(), &files.actions, nullptr, arguments.data(), environ) == 0 ? child : 0;
}

// The number that Xvfb writes when it is ready, up to a quarter of a minute from now; empty when it does not.
std::string number_from(int pipe) {
  std::string text;
  pollfd waiting{pipe, POLLIN, 0};
  constexpr int patience = 15'000;  // [ms]
  while (poll(&waiting, 1, patience) > 0) {
    std::array<char, 16> part{};
    const ssize_t count = read(pipe, part.data(), part.size());
    if (count <= 0) return "";
    text.append(part.data(), static_cast<std::size_t>(count));
    if (text.ends_with('\n')) return text.substr(0, text.size() - 1);
  }
  return "";
}

}  // namespace

Display::Display() {
  if (reachable()) return;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    why_not_ = "no display, and no pipe to start one";
    return;
  }
  FileActions files;
  posix_spawn_file_actions_adddup2(&files.actions, ends[1], 3);
  posix_spawn_file_actions_addopen(&files.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // -noreset: else the server starts over when its last client leaves, as VTK does between two windows.
  server_ = start({"Xvfb", "-displayfd", "3", "-noreset", "-screen", "0", "1280x1024x24", "-nolisten", "tcp"}, files);
  close(ends[1]);
  const std::string number = server_ > 0 ? number_from(ends[0]) : "";
  close(ends[0]);
  if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
  if (number.empty() || !reachable()) {
    why_not_ =
        "VTK draws on a display only, $DISPLAY names none that can be reached, and Xvfb, which would be one without "
        "a screen, does not start; apt-get install xvfb";
  }
}

Display::~Display() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

int run_program(const std::vector<std::string>& command, const std::filesystem::path& log) {
  FileActions files;
  posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files.actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files.actions, STDOUT_FILENO, STDERR_FILENO);
  constexpr int no_such_program = 127;
  const pid_t child = start(command, files);
  if (child == 0) return no_such_program;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace thalweg
