#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// A column's heading, "bed [m]": name and unit.
struct CsvColumn {
  std::string name;
  std::string unit;  // empty when the heading has none

  [[nodiscard]] std::string heading() const;
};

/// The last line of a table that a program is still writing may be cut off: one without its end is left out then.
enum class LastLine { whole, may_be_cut };

/// A CSV table as described in docs/file-formats.md: commas, one heading line with units, `#` comment lines. Cells are
/// kept as text; numbers() converts a column.
class CsvTable {
 public:
  /// An empty table to fill.
  explicit CsvTable(std::vector<CsvColumn> columns) : columns_(std::move(columns)) {}

  /// Reads a table. Throws InputError "file:line: what is wrong; what to do" if there is no such file, no heading, a
  /// heading twice, a row with too many or too few cells, or a quote that is not closed.
  static CsvTable read(const std::filesystem::path& file, LastLine last = LastLine::whole);

  /// Writes the table, whole or not at all. Throws RunError.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] const std::vector<CsvColumn>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return cells_.size(); }
  [[nodiscard]] bool has(std::string_view name) const;

  /// The column's cells as text. Throws InputError naming the file and its columns if it has no column of this name.
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;

  /// The column's cells as numbers, NaN for an empty cell. Throws InputError if a cell is no number (with its line) or
  /// if the heading's unit is not `unit`.
  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::string_view unit) const;

  /// "file:line" of a row, for messages about its values.
  [[nodiscard]] std::string where(std::size_t row) const;
  /// "file:line" of the heading.
  [[nodiscard]] std::string where() const;

  /// Leading comment lines, without "# ".
  std::vector<std::string> comments;

  /// Appends a row; `cells` has one entry per column.
  void add_row(std::vector<std::string> cells) { cells_.push_back(std::move(cells)); }

 private:
  [[nodiscard]] std::size_t index_of(std::string_view name) const;
  void take_heading(const std::vector<std::string>& headings);

  std::vector<CsvColumn> columns_;
  std::vector<std::vector<std::string>> cells_;
  std::filesystem::path file_;
  int heading_line_ = 1;
  std::vector<int> lines_;  // of the rows, when read from a file
};

/// The shortest text that reads back as the same number; empty for NaN.
std::string csv_number(double value);

}  // namespace thalweg
