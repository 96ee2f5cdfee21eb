#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// The seal of a file: its last line, an XML comment with a checksum of all that stands before. It tells a file that a
// disk, a transfer or a power cut has changed from the one that was written, before anything is read of it.
namespace thalweg {

enum class SealState { none, whole, broken };

/// The seal of contents that come in parts.
class Seal {
 public:
  void add(std::string_view part);
  [[nodiscard]] std::string text() const;

 private:
  unsigned long checksum_ = 0;
};

/// The seal of these contents.
std::string seal_of(std::string_view contents);

/// `none` for a file without a seal, of other programs or cut off. Throws InputError if the file cannot be read.
SealState seal_state(const std::filesystem::path& file);

}  // namespace thalweg
