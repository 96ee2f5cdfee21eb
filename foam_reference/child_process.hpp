#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace thalweg::foam {

/// A program running beside this one, in a process group of its own so that it ends with all it started.
class ChildProcess {
 public:
  /// Starts `command` with its output in `log`. Throws RunError.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether it still runs.
  bool running();
  /// Waits until it has ended.
  void wait();
  /// Ends it and all it started, and waits for that.
  void end();

  [[nodiscard]] bool succeeded() const { return succeeded_; }  // once it has ended: exit status 0
  [[nodiscard]] double cpu_seconds() const {
    return cpu_seconds_;
  }  // once it has ended: user + system, of all it started

 private:
  void collect(int options);

  pid_t process_ = -1;  // -1 once it has ended
  bool succeeded_ = false;
  double cpu_seconds_ = 0;
};

/// While it lives, Ctrl-C and SIGTERM do not end the program but are remembered.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// SIGINT, SIGTERM, or 0 when there was none.
  [[nodiscard]] static int received();
};

}  // namespace thalweg::foam
