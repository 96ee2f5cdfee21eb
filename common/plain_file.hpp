#pragma once

#include <filesystem>
#include <string>

#include "common/error.hpp"

namespace thalweg {

/// Refuses what is there and is no plain file: a pipe may never begin, and a device may never end. `kind` names what is
/// wanted, "a table". Throws InputError.
inline void require_plain_file(const std::filesystem::path& file, const std::string& kind) {
  std::error_code ignored;  // what cannot be looked at cannot be opened either
  if (!std::filesystem::exists(file, ignored) || std::filesystem::is_regular_file(file, ignored)) return;
  throw InputError(file.string() + ": is no plain file; give " + kind + " that was written to the disk");
}

}  // namespace thalweg
