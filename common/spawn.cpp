#include "common/spawn.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "common/process.hpp"

// Between fork and exec a child of a program with threads may call only what is safe in a signal handler: no memory is
// taken there, and all words are ready before.
namespace thalweg {
namespace {

/// This process gets SIGTERM when its parent dies, and ends at once if that has happened already.
void bind_to(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(128 + SIGTERM);
}

/// Gives the signals that this program handles back to the system, as exec does a moment later; ignored ones stay so.
void forget_handlers() {
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
  }
}

[[noreturn]] void fail(int report) {
  const int cause = errno;
  (void)!write(report, &cause, sizeof cause);
  _exit(127);
}

/// Becomes the program. A failure goes to `report` as an errno.
[[noreturn]] void become_program(const std::string& program, char* const* arguments, const ChildStart& start,
                                 const sigset_t& signals, int report) {
  if (!start.folder.empty() && chdir(start.folder.c_str()) != 0) fail(report);
  if (start.log >= 0) {
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0) fail(report);
    if (dup2(start.log, STDOUT_FILENO) < 0 || dup2(start.log, STDERR_FILENO) < 0) fail(report);
  }
  if (start.to_stderr && dup2(STDERR_FILENO, STDOUT_FILENO) < 0) fail(report);
  if (start.piped >= 0 && dup2(start.pipe, start.piped) < 0) fail(report);
  forget_handlers();
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  execv(program.c_str(), arguments);
  fail(report);
}

/// Ends as the program did whose status `wait` gave.
[[noreturn]] void end_as(int status) {
  if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int ended_by = WTERMSIG(status);
  forget_handlers();
  raise(ended_by);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, ended_by);
  sigprocmask(SIG_UNBLOCK, &one, nullptr);
  _exit(128 + ended_by);
}

/// Waits for all children, those of the program that lost their parent too, and kills the group of whoever is left after
/// the grace. Returns the status of the program.
int end_group(pid_t program) {
  std::signal(SIGTERM, SIG_IGN);  // it goes to the whole group, to this process as well
  kill(0, SIGTERM);
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  int status_of_program = SIGTERM;
  for (int tenths = 0; tenths < 10 * grace_seconds; ++tenths) {
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(-1, &status, WNOHANG)) > 0) {
      if (ended == program) status_of_program = status;
    }
    if (ended < 0) return status_of_program;  // no child is left
    const timespec pause{0, 100'000'000};
    sigtimedwait(&child_ended, nullptr, &pause);
  }
  kill(0, SIGKILL);
  return status_of_program;
}

/// The keeper of a group: waits for the program, and for a signal to end it. All signals are blocked.
[[noreturn]] void keep(pid_t program) {
  sigset_t awaited;
  sigemptyset(&awaited);
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&awaited, signal);
  for (;;) {
    int status = 0;
    if (waitpid(program, &status, WNOHANG) == program) end_as(status);
    const int signal = sigwaitinfo(&awaited, nullptr);
    if (signal > 0 && signal != SIGCHLD) end_as(end_group(program));
  }
}

/// Becomes the keeper of a group of its own and starts the program in it.
[[noreturn]] void become_keeper(const std::string& program, char* const* arguments, const ChildStart& start,
                                const sigset_t& signals, int report) {
  setpgid(0, 0);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  forget_handlers();
  std::signal(SIGCHLD, SIG_DFL);
  const pid_t keeper = getpid();
  const pid_t child = fork();
  if (child < 0) fail(report);
  if (child == 0) {
    bind_to(keeper);
    become_program(program, arguments, start, signals, report);
  }
  close_range(STDERR_FILENO + 1, ~0U, 0);  // pipes that others read to their end, and the lock of a run
  keep(child);
}

/// Blocks all signals while it lives.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  [[nodiscard]] const sigset_t& before() const { return before_; }

 private:
  sigset_t before_{};
};

}  // namespace

std::vector<char*> argument_list(const std::vector<std::string>& command) {
  std::vector<char*> list;
  for (const std::string& word : command) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  return list;
}

std::string find_program(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / program;
    std::error_code ignored;
    if (access(file.c_str(), X_OK) == 0 && !std::filesystem::is_directory(file, ignored)) return file.string();
  }
  return "";
}

pid_t spawn(const std::vector<std::string>& command, const ChildStart& start) {
  const std::string& name = command.front();
  const std::string program = name.find('/') == std::string::npos ? find_program(name) : name;
  if (program.empty()) throw StartError(name, ENOENT);
  const std::vector<char*> arguments = argument_list(command);
  std::array<int, 2> report{};
  if (pipe2(report.data(), O_CLOEXEC) != 0) throw StartError(name, errno);

  const pid_t parent = getpid();
  pid_t child = 0;
  int cause = 0;
  {
    const SignalsBlocked signals;
    child = fork();
    if (child == 0) {
      bind_to(parent);
      if (start.own_group) become_keeper(program, arguments.data(), start, signals.before(), report[1]);
      become_program(program, arguments.data(), start, signals.before(), report[1]);
    }
    if (child < 0) cause = errno;
  }
  close(report[1]);
  // The pipe closes without a word when the child becomes its program.
  ssize_t count = child < 0 ? 0 : read(report[0], &cause, sizeof cause);
  while (count < 0 && errno == EINTR) count = read(report[0], &cause, sizeof cause);
  close(report[0]);
  if (cause == 0) return child;
  while (child > 0 && waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  throw StartError(name, cause);
}

}  // namespace thalweg
