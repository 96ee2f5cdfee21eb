#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

// The beginning of a child process; programs use ChildProcess (common/process.hpp).
namespace thalweg {

/// Time [s] that programs get to end after SIGTERM before they are killed.
inline constexpr int grace_seconds = 10;

/// The surroundings that a child prepares before it becomes its program.
struct ChildStart {
  int log = -1;   // descriptor that becomes its stdout and stderr, while it reads /dev/null; -1: none
  int pipe = -1;  // descriptor that becomes `piped`; -1: none
  int piped = -1;
  bool to_stderr = false;  // stdout goes where stderr goes
  std::string folder{};    // to work in; empty: this program's
  bool own_group = false;
};

/// Starts `command`, a program and its arguments, looked for along PATH if it has no slash. The child gets SIGTERM when
/// this program dies. With a group of its own, a keeper process stands between the two: it passes on how the program
/// ended, and when this program dies, or on SIGTERM, it ends all that the program has started. Returns the id of the
/// child or of its keeper, which leads the group. Throws StartError.
pid_t spawn(const std::vector<std::string>& command, const ChildStart& start);

/// The path of a program that is looked for along PATH; empty if there is none.
std::string find_program(const std::string& program);

/// The words of a command as the system wants them; they live as long as the command.
std::vector<char*> argument_list(const std::vector<std::string>& command);

}  // namespace thalweg
