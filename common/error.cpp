#include "common/error.hpp"

#include <algorithm>
#include <cstdio>
#include <new>

namespace thalweg {
namespace {

int report(Exit status, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');  // users and scripts rely on one line per error
  std::fflush(stdout);
  std::fprintf(stderr, "error: %s\n", message.c_str());
  return static_cast<int>(status);
}

}  // namespace

int run_program(int (*body)(int, char**), int argc, char** argv) noexcept {
  try {
    return body(argc, argv);
  } catch (const InputError& error) {
    return report(Exit::input_wrong, error.what());
  } catch (const RunError& error) {
    return report(Exit::run_failed, error.what());
  } catch (const std::bad_alloc&) {
    return report(Exit::run_failed, "out of memory; use a larger spacing or a machine with more memory");
  } catch (const std::exception& error) {
    return report(Exit::run_failed, std::string("unexpected failure: ") + error.what() +
                                        "; this is a defect of Thalweg, please report it with the case");
  }
}

}  // namespace thalweg
