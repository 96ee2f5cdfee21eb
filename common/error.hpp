#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace thalweg {

/// The input is wrong: exit status 2. `what()` reads "where: what is wrong; what to do".
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run failed (diverged, disk full, too much excluded …): exit status 1. `what()` names the cause and the cure.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exit statuses of every Thalweg program.
enum class Exit : int { done = 0, run_failed = 1, input_wrong = 2, interrupted = 130, terminated = 143 };

/// Runs a program's body and turns exceptions into the one-line message and exit status that every Thalweg program
/// promises. `body` takes the arguments of main and returns the exit status.
int run_program(int (*body)(int, char**), int argc, char** argv) noexcept;

}  // namespace thalweg
