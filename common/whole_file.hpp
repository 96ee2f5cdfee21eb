#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace thalweg {

/// The way in which a whole file is put in its place.
struct WholeFile {
  std::filesystem::path previous{};  // keeps what stood there before, under this name; empty: that is lost
  bool make_folders = true;          // false: a folder that is gone is an error
};

/// Writes a file that appears whole or not at all, also if the power fails: `write` fills a temporary file in the same
/// folder, which is brought to the disk and renamed to `file`; then the folder's entry is brought to the disk. Throws
/// RunError naming file and cause; the temporary file is removed if anything throws.
void write_whole_file(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path& temporary)>& write,
                      const WholeFile& how = {});

/// The same for bytes that are known.
void write_whole_bytes(const std::filesystem::path& file, std::string_view bytes, const WholeFile& how = {});

/// The same for text: `write` fills a stream in memory.
void write_whole_text(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write,
                      const WholeFile& how = {});

/// Brings what has been written to a file to the disk. Throws RunError.
void sync_file(const std::filesystem::path& file);

/// Removes the temporary files that killed programs have left in `folder` and below it. Those of programs that still
/// run stay.
void remove_dead_parts(const std::filesystem::path& folder);

}  // namespace thalweg
