#include "common/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "common/console.hpp"
#include "common/input_errors.hpp"

namespace thalweg {
namespace {

int report(Exit status, std::vector<std::string> messages) {
  std::fflush(stdout);
  for (std::string& message : messages) {
    std::replace(message.begin(), message.end(), '\n', ' ');  // users and scripts rely on one line per error
    std::fprintf(stderr, "error: %s\n", message.c_str());
    log_line("error", message);
  }
  print_answer(static_cast<int>(status), messages);
  return static_cast<int>(status);
}

int report(Exit status, const std::string& message) { return report(status, std::vector<std::string>{message}); }

/// Descriptors 0 to 2 that the caller has closed lead to /dev/null; otherwise the next file that is opened gets their
/// number, and the log's lines.
void open_standard_descriptors() {
  int descriptor = open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDWR);
  if (descriptor >= 0) close(descriptor);
}

/// Text that stays in the buffers is lost when a program ends.
bool brought_out() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

}  // namespace

int run_program(int (*body)(int, char**), int argc, char** argv) noexcept {
  open_standard_descriptors();
  // A file that meets the limit on sizes is an error of the write then, as a full disk is, and no end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  // "Write now" to a whole pipeline concerns the solver alone, which has said by now that it listens.
  if (const auto before = std::signal(SIGUSR1, SIG_IGN); before != SIG_DFL) std::signal(SIGUSR1, before);
  try {
    const int status = body(argc, argv);
    print_answer(status, {});
    if (brought_out() || status != 0) return status;
    return report(Exit::run_failed, "standard output cannot be written; check the free space where it goes");
  } catch (const InputErrors& errors) {
    return report(Exit::input_wrong, errors.messages());
  } catch (const InputError& error) {
    return report(Exit::input_wrong, error.what());
  } catch (const RunError& error) {
    return report(Exit::run_failed, error.what());
  } catch (const std::bad_alloc&) {
    return report(Exit::run_failed, "out of memory; use a larger spacing or a machine with more memory");
  } catch (const std::filesystem::filesystem_error& error) {
    return report(Exit::run_failed, error.path1().string() + ": " + error.code().message() +
                                        "; check the name, the permissions and the free space");
  } catch (const std::exception& error) {
    return report(Exit::run_failed, std::string("unexpected failure: ") + error.what() +
                                        "; this is a defect of Thalweg, please report it with the case");
  }
}

}  // namespace thalweg
