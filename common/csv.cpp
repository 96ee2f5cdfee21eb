#include "common/csv.hpp"

#include <csv.h>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <ostream>

#include "common/error.hpp"
#include "common/plain_file.hpp"
#include "common/shown.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// Splits a line into cells with libcsv, which also treats quotes and the blanks around cells.
class LineSplitter {
 public:
  LineSplitter() { csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI); }
  void separate_by(char separator) { csv_set_delim(&parser_, static_cast<unsigned char>(separator)); }
  ~LineSplitter() { csv_free(&parser_); }
  LineSplitter(const LineSplitter&) = delete;
  LineSplitter& operator=(const LineSplitter&) = delete;

  // Throws std::invalid_argument when the quotes do not match.
  std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    const auto take_cell = [](void* text, std::size_t length, void* to) {
      static_cast<std::vector<std::string>*>(to)->emplace_back(static_cast<const char*>(text), length);
    };
    const auto end_of_row = [](int, void*) {};
    const bool complete = csv_parse(&parser_, line.data(), line.size(), take_cell, end_of_row, &cells) == line.size() &&
                          csv_fini(&parser_, take_cell, end_of_row, &cells) == 0;
    if (!complete) throw std::invalid_argument("the quotes do not match; write a quote inside a cell twice");
    return cells;
  }

 private:
  csv_parser parser_{};
};

std::string cell_text(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted(2 * cell.size() + 2, '\0');
  quoted.resize(csv_write(quoted.data(), quoted.size(), cell.data(), cell.size()));
  return quoted;
}

// The separator of the cells: of commas, semicolons and tabs the one that a heading has most of.
char separator_of(const std::string& heading) {
  const auto count = [&](char c) { return std::count(heading.begin(), heading.end(), c); };
  char most = ',';
  for (const char c : {';', '\t'})
    if (count(c) > count(most)) most = c;
  return most;
}

/// The finite number that is the whole cell.
std::optional<double> number_in(const std::string& cell) {
  double value = 0;
  const char* const end = cell.data() + cell.size();
  const auto parsed = std::from_chars(cell.data(), end, value);
  if (parsed.ec != std::errc{} || parsed.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

// The fault of a cell that should hold a number. Decimal commas are asked about, never guessed.
std::string fault_of(const std::string& cell, const std::string& column) {
  std::string pointed = cell;
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  if (pointed != cell && number_in(pointed))
    return fmt::format("\"{}\" in the column \"{}\" has a decimal comma; write {} in the whole table", shown(cell),
                       column, shown(pointed));
  if (cell.find_first_of(" \t;") != std::string::npos)
    return fmt::format("\"{}\" in the column \"{}\" is no number; separate the cells by what separates the heading's",
                       shown(cell), column);
  return fmt::format("\"{}\" in the column \"{}\" is no number; correct it or leave the cell empty", shown(cell),
                     column);
}

CsvColumn column_of(const std::string& heading) {
  const auto open = heading.find('[');
  if (open == std::string::npos || !heading.ends_with(']')) return {heading, ""};
  std::string name = heading.substr(0, open);
  name.erase(name.find_last_not_of(' ') + 1);
  return {name, heading.substr(open + 1, heading.size() - open - 2)};
}

}  // namespace

std::string CsvColumn::heading() const { return unit.empty() ? name : fmt::format("{} [{}]", name, unit); }

std::string csv_number(double value) { return std::isnan(value) ? std::string() : fmt::format("{}", value); }

CsvTable CsvTable::read(const fs::path& file, LastLine last) {
  require_plain_file(file, "a table");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be opened; check the name and the permissions");
  CsvTable table({});
  table.file_ = file;
  LineSplitter splitter;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (last == LastLine::may_be_cut && stream.eof()) break;
    if (line.ends_with('\r')) line.pop_back();
    if (line_number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // spreadsheets write this mark
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    if (line.starts_with('#')) {
      if (table.columns_.empty())
        table.comments.push_back(line.substr(std::min(line.size(), line.find_first_not_of("# "))));
      continue;
    }
    if (table.columns_.empty()) splitter.separate_by(separator_of(line));
    std::vector<std::string> cells;
    try {
      cells = splitter.split(line);
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}:{}: {}", file.string(), line_number, error.what()));
    }
    if (table.columns_.empty()) {
      table.heading_line_ = line_number;
      if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return number_in(cell).has_value(); }))
        throw InputError(
            fmt::format("{}: there is no heading line, only numbers; begin with names and units, as in \"x [m], y [m], "
                        "z [m]\"",
                        table.where()));
      table.take_heading(cells);
      continue;
    }
    if (cells.size() != table.columns_.size()) {
      throw InputError(fmt::format("{}:{}: the row has {} cells and the heading {}; add or remove commas",
                                   file.string(), line_number, cells.size(), table.columns_.size()));
    }
    table.cells_.push_back(std::move(cells));
    table.lines_.push_back(line_number);
  }
  if (table.columns_.empty()) {
    throw InputError(fmt::format("{}:1: there is no heading line; begin with names and units, as in \"x [m], bed [m]\"",
                                 file.string()));
  }
  return table;
}

void CsvTable::take_heading(const std::vector<std::string>& headings) {
  for (const std::string& heading : headings) {
    CsvColumn column = column_of(heading);
    if (has(column.name)) {
      throw InputError(
          fmt::format("{}: the heading names \"{}\" twice; rename one column", where(), shown(column.name)));
    }
    columns_.push_back(std::move(column));
  }
}

void CsvTable::write(const fs::path& file) const {
  write_whole_text(file, [&](std::ostream& to) {
    const auto write_row = [&](const std::vector<std::string>& cells) {
      for (std::size_t i = 0; i < cells.size(); ++i) to << (i == 0 ? "" : ",") << cell_text(cells[i]);
      to << '\n';
    };
    for (const std::string& comment : comments) fmt::print(to, "# {}\n", comment);
    std::vector<std::string> headings;
    for (const CsvColumn& column : columns_) headings.push_back(column.heading());
    write_row(headings);
    for (const std::vector<std::string>& row : cells_) write_row(row);
  });
}

bool CsvTable::has(std::string_view name) const {
  return std::any_of(columns_.begin(), columns_.end(), [&](const CsvColumn& column) { return column.name == name; });
}

std::size_t CsvTable::index_of(std::string_view name) const {
  constexpr std::size_t listed = 7;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == name) return i;
    if (i < listed) names.push_back(shown(columns_[i].name));
  }
  throw InputError(fmt::format("{}: there is no column \"{}\"; the columns are {}{}", where(), shown(name),
                               fmt::join(names, ", "), columns_.size() > listed ? ", ..." : ""));
}

std::vector<std::string> CsvTable::texts(std::string_view name) const {
  const std::size_t column = index_of(name);
  std::vector<std::string> result;
  result.reserve(cells_.size());
  for (const std::vector<std::string>& row : cells_) result.push_back(row[column]);
  return result;
}

std::vector<double> CsvTable::numbers(std::string_view name, std::string_view unit) const {
  const CsvColumn& column = columns_[index_of(name)];
  if (column.unit != unit) {
    throw InputError(
        fmt::format("{}: the column \"{}\" is not in {}; head it \"{} [{}]\" and give its values in that unit", where(),
                    shown(column.heading()), shown(unit), shown(name), shown(unit)));
  }
  std::vector<double> result;
  result.reserve(cells_.size());
  const std::size_t index = index_of(name);
  std::string fault;
  std::vector<int> further;  // lines of other cells that are no number
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const std::string& cell = cells_[row][index];
    const auto value = number_in(cell);
    result.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (value || cell.empty()) continue;
    if (fault.empty())
      fault = fmt::format("{}: {}", where(row), fault_of(cell, shown(name)));
    else if (row < lines_.size())
      further.push_back(lines_[row]);
  }
  if (fault.empty()) return result;
  constexpr std::size_t listed = 5;
  const std::size_t count = further.size();
  if (count > listed) further.resize(listed);
  if (count > 0)
    fault += fmt::format(" (as in line {}{})", fmt::join(further, ", "),
                         count > listed ? fmt::format(" and {} more", count - listed) : "");
  throw InputError(fault);
}

std::string CsvTable::where(std::size_t row) const {
  return row < lines_.size() ? fmt::format("{}:{}", file_.string(), lines_[row]) : file_.string();
}

std::string CsvTable::where() const { return fmt::format("{}:{}", file_.string(), heading_line_); }

}  // namespace thalweg
