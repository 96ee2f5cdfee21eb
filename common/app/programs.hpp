#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace thalweg {

/// The short names ("gencase") of the stages' programs that stand next to this one, sorted.
std::vector<std::string> installed_stages();

/// The program `thalweg-<stage>` next to this one. Throws InputError, with the nearest name, when there is none.
std::filesystem::path stage_program(const std::string& stage);

}  // namespace thalweg
