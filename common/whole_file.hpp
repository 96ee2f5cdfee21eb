#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace thalweg {

/// Writes a file that appears whole or not at all: `write` fills a temporary file in the same folder, which is then
/// renamed to `file`. Missing folders are made. Throws RunError naming file and cause; the temporary file is removed if
/// anything throws.
void write_whole_file(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text: `write` fills a stream.
void write_whole_text(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace thalweg
