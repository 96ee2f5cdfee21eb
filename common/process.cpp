#include "common/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <type_traits>
#include <utility>

#include "common/console.hpp"
#include "common/spawn.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// An open file or an end of a pipe. Children inherit it by dup2 only.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

Descriptor open_log(const fs::path& log) {
  Descriptor file(open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.is_open()) return file;
  throw RunError(
      fmt::format("{}: cannot be written: {}; check the folder's permissions", log.string(), std::strerror(errno)));
}

/// The two ends of a pipe, to read from and to write to.
std::array<Descriptor, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw RunError(fmt::format("a pipe cannot be opened: {}; close other programs", std::strerror(errno)));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

// A signal may come to any thread.
std::atomic<pid_t> foreground_child = 0;
std::atomic<int> remembered_signal = 0;
static_assert(std::is_same_v<pid_t, int> && std::atomic<int>::is_always_lock_free);

extern "C" void leave_to_child(int) {}
extern "C" void remember(int signal) { remembered_signal = signal; }
extern "C" void pass_on(int signal) {
  if (const pid_t child = foreground_child; child > 0) {
    kill(child, signal);
  } else {
    remember(signal);
  }
}

/// Handles a signal in this way while it lives. A child starts with the system's own handling, since a handler does not
/// outlive exec.
class Handler {
 public:
  Handler(int signal, void (*handle)(int)) : signal_(signal) {
    struct sigaction action {};
    action.sa_handler = handle;
    sigaction(signal_, &action, &before_);
    if (signal == SIGHUP && before_.sa_handler == SIG_IGN) sigaction(signal_, &before_, nullptr);  // under nohup
  }
  ~Handler() { sigaction(signal_, &before_, nullptr); }
  Handler(const Handler&) = delete;
  Handler& operator=(const Handler&) = delete;

 private:
  int signal_;
  struct sigaction before_ {};
};

}  // namespace

StartError::StartError(const std::string& program, int cause)
    : RunError(fmt::format("{}: cannot be started: {}; install or build it again", program, std::strerror(cause))),
      not_found_(cause == ENOENT) {}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildSetup& setup)
    : own_group_(setup.own_group) {
  Descriptor log;
  std::array<Descriptor, 2> pipe;
  if (!setup.log.empty()) log = open_log(setup.log);
  if (setup.piped >= 0) pipe = make_pipe();
  say_detail(fmt::format("starts {}", fmt::join(command, " ")));
  process_ = spawn(command, {.log = log.number(),
                             .pipe = pipe[1].number(),
                             .piped = setup.piped,
                             .to_stderr = setup.to_stderr,
                             .folder = setup.folder.string(),
                             .own_group = own_group_});
  pipe_ = pipe[0].release();
}

ChildProcess::~ChildProcess() {
  end();
  if (pipe_ >= 0) close(pipe_);
}

bool ChildProcess::running() {
  if (process_ > 0) collect(WNOHANG);
  return process_ > 0;
}

int ChildProcess::wait() {
  if (process_ > 0) collect(0);
  return status_;
}

bool ChildProcess::ends_within(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds longest{20};
  const auto end = std::chrono::steady_clock::now() + patience;
  for (std::chrono::milliseconds pause{1}; running(); pause = std::min(2 * pause, longest)) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}

void ChildProcess::end(int signal) {
  if (process_ <= 0) return;
  kill(own_group_ ? -process_ : process_, signal);
  constexpr std::chrono::milliseconds grace(grace_seconds * 1000);
  // The keeper of a group counts the grace itself.
  if (!own_group_) {
    if (ends_within(grace)) return;
    kill(process_, SIGKILL);
  }
  collect(0);
}

std::optional<std::string> ChildProcess::read_line(std::chrono::milliseconds patience) {
  pollfd waiting{pipe_, POLLIN, 0};
  while (read_.find('\n') == std::string::npos) {
    const int ready = poll(&waiting, 1, static_cast<int>(patience.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return std::nullopt;
    std::array<char, 4096> part{};
    const ssize_t count = read(pipe_, part.data(), part.size());
    if (count <= 0) return std::nullopt;
    read_.append(part.data(), static_cast<std::size_t>(count));
  }
  const std::size_t end = read_.find('\n');
  std::string line = read_.substr(0, end);
  read_.erase(0, end + 1);
  return line;
}

void ChildProcess::collect(int options) {
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do {
    ended = wait4(process_, &status, options, &usage);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return;  // it still runs
  process_ = -1;
  if (ended < 0) {  // reaped by someone else: its status is lost and counts as a failure
    status_ = 1;
    return;
  }
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  cpu_seconds_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int run_in_foreground(const std::vector<std::string>& command, bool stdout_to_stderr) {
  remembered_signal = 0;
  const Handler interrupt(SIGINT, leave_to_child);
  const Handler terminate(SIGTERM, pass_on);
  const Handler hang_up(SIGHUP, pass_on);
  const Handler write_now(SIGUSR1, pass_on);
  ChildProcess child(command, {.to_stderr = stdout_to_stderr});
  foreground_child = child.id();
  if (remembered_signal != 0) kill(child.id(), remembered_signal);  // it came while the child was being started
  const int status = child.wait();
  foreground_child = 0;
  return status;
}

void become(const std::vector<std::string>& command) {
  execvp(command.front().c_str(), argument_list(command).data());
  throw StartError(command.front(), errno);
}

bool on_path(const std::string& program) { return !find_program(program).empty(); }

SignalWatch::SignalWatch() {
  remembered_signal = 0;
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

SignalWatch::~SignalWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int SignalWatch::received() { return remembered_signal; }

}  // namespace thalweg
