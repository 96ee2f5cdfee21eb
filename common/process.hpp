#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/error.hpp"

// The one way to start other programs. It uses the system's own calls: Boost.Process 1.74 reports neither the CPU time of
// a child nor the signal that ended it, and posix_spawn cannot bind a child's life to its parent's.
namespace thalweg {

/// A program could not be started. `what()` names it, the cause and the cure.
class StartError : public RunError {
 public:
  StartError(const std::string& program, int cause);

  /// True if there is no program of this name.
  [[nodiscard]] bool not_found() const { return not_found_; }

 private:
  bool not_found_;
};

/// Surroundings of a child; the defaults are this program's own.
struct ChildSetup {
  std::filesystem::path log{};     // takes stdout and stderr, and nothing comes from stdin; empty: as this program's
  std::filesystem::path folder{};  // working folder; empty: this program's
  bool to_stderr = false;          // its stdout goes to this program's stderr
  bool own_group = false;          // a process group of its own: end() then ends also all that the child started
  int piped = -1;                  // descriptor of the child that read_line() reads: 1 is its stdout; -1: none
};

/// A program that runs beside this one. It ends when this object does, and it gets SIGTERM if this program dies in any
/// way, by SIGKILL too. With a group of its own, all that the child started ends then.
class ChildProcess {
 public:
  /// Starts `command`: a program, looked for along PATH if it has no slash, and its arguments. Throws StartError, and
  /// RunError where the log cannot be written.
  explicit ChildProcess(const std::vector<std::string>& command, const ChildSetup& setup = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// True until the child has ended.
  bool running();
  /// Waits for the child to end, no longer than `patience`. False if it still runs.
  bool ends_within(std::chrono::milliseconds patience);
  /// Waits until the child has ended. Returns its exit status, or 128 + n if signal n ended it.
  int wait();
  /// Ends the child by this signal, with its group if it has its own, and waits for that; one that does not heed it is
  /// killed after some seconds (`grace_seconds`).
  void end(int signal = SIGTERM);
  /// The next line from the piped descriptor, without its end. Nothing if the child closes it before the end of a line,
  /// or writes nothing for `patience`; a negative patience waits without limit.
  std::optional<std::string> read_line(std::chrono::milliseconds patience = std::chrono::milliseconds(-1));

  [[nodiscard]] pid_t id() const { return process_; }                // -1 once it has ended
  [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }  // [s] user and system, of it and all it waited for

 private:
  void collect(int options);

  pid_t process_ = -1;
  bool own_group_ = false;
  int pipe_ = -1;     // the end that this program reads; -1: none
  std::string read_;  // from it, after the last line returned
  int status_ = 0;
  double cpu_seconds_ = 0;
};

/// Runs `command` to its end in this program's place on the terminal, and returns its exit status, or 128 + n if signal
/// n ended it. Ctrl-C reaches the child as it reaches this program, which waits for the child to finish in its own way.
/// SIGTERM, SIGHUP and SIGUSR1, which batch systems send to the parent alone, are passed on. Throws StartError.
/// With `stdout_to_stderr` this program keeps its stdout for itself.
int run_in_foreground(const std::vector<std::string>& command, bool stdout_to_stderr = false);

/// Replaces this program by `command`; does not return. Throws StartError.
[[noreturn]] void become(const std::vector<std::string>& command);

/// True if a program of this name is found along PATH.
bool on_path(const std::string& program);

/// While it lives, Ctrl-C and SIGTERM do not end this program but are remembered.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// SIGINT, SIGTERM, or 0 when there was none.
  [[nodiscard]] static int received();
};

}  // namespace thalweg
