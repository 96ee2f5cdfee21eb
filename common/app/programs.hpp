#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace thalweg {

/// The programs of the stages that stand next to this one, by their short names ("gencase"), sorted.
std::vector<std::string> installed_stages();

/// The program `thalweg-<stage>` next to this one. Throws InputError, with the nearest name, when there is none.
std::filesystem::path stage_program(const std::string& stage);

/// Becomes `program` with these arguments; does not return. Throws RunError when it cannot be started.
[[noreturn]] void become(const std::filesystem::path& program, const std::vector<std::string>& arguments);

/// Runs `program` and returns its exit status, 128 + n when signal n ended it. Ctrl-C reaches it as it reaches this
/// program, which waits for it to finish in its own way; SIGTERM is passed on. Throws RunError when it cannot start.
int run_and_wait(const std::filesystem::path& program, const std::vector<std::string>& arguments);

/// Whether a command of this name is found along PATH.
bool on_path(const std::string& command);

}  // namespace thalweg
