#include "common/app/programs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "case/nearest.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "thalweg-";

fs::path own_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

std::vector<char*> argument_list(const fs::path& program, const std::vector<std::string>& arguments) {
  std::vector<char*> list{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
  list.push_back(nullptr);
  return list;
}

[[noreturn]] void cannot_start(const fs::path& program, int cause) {
  throw RunError(
      fmt::format("{}: cannot be started: {}; install or build it again", program.string(), std::strerror(cause)));
}

volatile std::sig_atomic_t running_child = 0;

extern "C" void pass_on(int signal) {
  if (running_child > 0) kill(static_cast<pid_t>(running_child), signal);
}

// While it lives: Ctrl-C, which the terminal sends to the child as well, is left to the child, and SIGTERM, which
// batch systems send to the parent alone, is passed on to it.
class SignalsToChild {
 public:
  SignalsToChild() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGINT, &ignore, &interrupt_);
    struct sigaction forward {};
    forward.sa_handler = pass_on;
    sigaction(SIGTERM, &forward, &terminate_);
  }
  ~SignalsToChild() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
  }
  SignalsToChild(const SignalsToChild&) = delete;
  SignalsToChild& operator=(const SignalsToChild&) = delete;

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
};

}  // namespace

std::vector<std::string> installed_stages() {
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(own_folder())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && access(entry.path().c_str(), X_OK) == 0)
      stages.push_back(name.substr(prefix.size()));
  }
  std::sort(stages.begin(), stages.end());
  return stages;
}

fs::path stage_program(const std::string& stage) {
  const std::vector<std::string> stages = installed_stages();
  if (std::find(stages.begin(), stages.end(), stage) != stages.end()) {
    return own_folder() / fmt::format("{}{}", prefix, stage);
  }
  std::vector<std::string> commands{"run", "explain", "info"};
  commands.insert(commands.end(), stages.begin(), stages.end());
  const auto near = nearest(stage, commands);
  throw InputError(fmt::format(
      "thalweg: there is no command {}; {}", stage,
      near ? fmt::format("did you mean {}?", *near) : fmt::format("the commands are {}", fmt::join(commands, ", "))));
}

void become(const fs::path& program, const std::vector<std::string>& arguments) {
  execv(program.c_str(), argument_list(program, arguments).data());
  cannot_start(program, errno);
}

int run_and_wait(const fs::path& program, const std::vector<std::string>& arguments) {
  const SignalsToChild signals;
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t restored;
  sigemptyset(&restored);
  sigaddset(&restored, SIGINT);
  posix_spawnattr_setsigdefault(&attributes, &restored);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int failure =
      posix_spawn(&child, program.c_str(), nullptr, &attributes, argument_list(program, arguments).data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (failure != 0) cannot_start(program, failure);
  running_child = child;

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) cannot_start(program, errno);
  }
  running_child = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool on_path(const std::string& command) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((fs::path(folder) / command).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace thalweg
