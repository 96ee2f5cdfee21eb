#include "foam_reference/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "common/error.hpp"

namespace thalweg::foam {
namespace {

volatile std::sig_atomic_t received_signal = 0;

void remember(int signal) { received_signal = signal; }

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);

  const int failure = posix_spawnp(&process_, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (failure == 0) return;
  process_ = -1;
  throw RunError(command.front() + " cannot be started with output in " + log.string() + ": " + std::strerror(failure) +
                 "; check the folder's permissions");
}

ChildProcess::~ChildProcess() { end(); }

bool ChildProcess::running() {
  if (process_ > 0) collect(WNOHANG);
  return process_ > 0;
}

void ChildProcess::wait() {
  if (process_ > 0) collect(0);
}

void ChildProcess::end() {
  if (process_ <= 0) return;
  kill(-process_, SIGTERM);
  collect(0);
}

void ChildProcess::collect(int options) {
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do {
    ended = wait4(process_, &status, options, &usage);
  } while (ended < 0 && errno == EINTR);
  if (ended != process_) return;
  process_ = -1;
  succeeded_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  cpu_seconds_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

SignalWatch::SignalWatch() {
  received_signal = 0;
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

SignalWatch::~SignalWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int SignalWatch::received() { return received_signal; }

}  // namespace thalweg::foam
