#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace thalweg {

/// A table of a run (CSV) whose first column is time [s] and which grows by a row at a time. A row is there as a whole or
/// not at all, also where the disk is full.
class RunTable {
 public:
  /// Opens `file` for rows under `heading`. `keep_until` [s]: the rows up to that time of what stands there stay; a row
  /// that was cut off goes. Rows under another heading are put aside, into a file of another name. Throws RunError.
  RunTable(std::filesystem::path file, const std::string& heading, std::optional<double> keep_until);
  ~RunTable();
  RunTable(RunTable&& other) noexcept;
  RunTable& operator=(RunTable&& other) noexcept;

  /// Adds a row, given without its end. Throws RunError.
  void add(const std::string& row);
  /// Brings the rows to the disk. Throws RunError.
  void sync() const;
  /// Rows that were there when it was opened.
  [[nodiscard]] std::int64_t rows_kept() const { return kept_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::int64_t kept_ = 0;
};

}  // namespace thalweg
