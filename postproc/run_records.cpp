#include "postproc/run_records.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

#include "common/csv.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && stop == end ? std::make_optional(number) : std::nullopt;
}

// The table in a file, or nothing when there is no such file: every table of a run may be missing.
std::optional<CsvTable> table_in(const fs::path& file) {
  return fs::exists(file) ? std::make_optional(CsvTable::read(file, LastLine::may_be_cut)) : std::nullopt;
}

// The numbers of a column; none when the table does not have it.
std::vector<double> numbers_in(const CsvTable& table, const char* column, const char* unit) {
  return table.has(column) ? table.numbers(column, unit) : std::vector<double>();
}

}  // namespace

std::vector<Quantity> read_quantities(const fs::path& file) {
  const std::optional<CsvTable> table = table_in(file);
  if (!table) return {};
  const std::vector<std::string> names = table->texts("quantity");
  const std::vector<std::string> values = table->texts("value");
  const std::vector<std::string> units = table->texts("unit");
  std::vector<Quantity> quantities;
  for (std::size_t row = 0; row < names.size(); ++row) quantities.push_back({names[row], values[row], units[row]});
  return quantities;
}

std::optional<std::string> text_of(const std::vector<Quantity>& quantities, const std::string& name) {
  for (const Quantity& quantity : quantities) {
    if (quantity.name == name) return quantity.value;
  }
  return std::nullopt;
}

std::optional<double> number_of(const std::vector<Quantity>& quantities, const std::string& name) {
  const std::optional<std::string> text = text_of(quantities, name);
  return text ? number_in(*text) : std::nullopt;
}

History read_history(const fs::path& file) {
  History history;
  const std::optional<CsvTable> table = table_in(file);
  if (!table) return history;
  history.rows = table->rows();
  history.dt = table->numbers("dt", "s");
  for (const double speed : numbers_in(*table, "max_speed", "m/s"))
    history.max_speed = std::fmax(history.max_speed, speed);
  history.internal_energy = numbers_in(*table, "internal_energy", "J");
  history.water_mass = numbers_in(*table, "water_mass", "kg");
  history.sediment_mass = numbers_in(*table, "sediment_mass", "kg");
  std::map<std::string, std::size_t> count;
  for (const std::string& limiter : table->texts("dt_limiter")) ++count[limiter];
  for (const auto& [limiter, rows] : count) {
    history.limiters.push_back({limiter, static_cast<double>(rows) / static_cast<double>(history.rows)});
  }
  std::sort(history.limiters.begin(), history.limiters.end(),
            [](const History::Share& a, const History::Share& b) { return a.share > b.share; });
  return history;
}

std::vector<Timing> read_timing(const fs::path& file) {
  const std::optional<CsvTable> table = table_in(file);
  if (!table) return {};
  const std::vector<std::string> headings = table->texts("heading");
  const std::vector<double> seconds = table->numbers("seconds", "s");
  const std::vector<double> shares = table->numbers("share", "-");
  const std::vector<double> calls = table->numbers("calls", "-");
  std::vector<Timing> timing;
  for (std::size_t row = 0; row < headings.size(); ++row) {
    timing.push_back({headings[row], seconds[row], shares[row], calls[row]});
  }
  return timing;
}

std::vector<Repeatability> read_repeatability(const fs::path& file) {
  const std::optional<CsvTable> table = table_in(file);
  if (!table) return {};
  const std::vector<std::string> names = table->texts("curve");
  const std::vector<double> times = table->numbers("time", "s");
  const std::vector<double> rms = table->numbers("rms", "m");
  std::vector<Repeatability> scatter;
  for (std::size_t row = 0; row < names.size(); ++row) scatter.push_back({names[row], times[row], rms[row]});
  return scatter;
}

Computed read_computed(const RunFolder& run) {
  Computed found;
  std::string line;
  std::ifstream lock(run.lock());
  std::getline(lock, line);
  constexpr std::string_view before_host = " on ";
  if (const std::size_t at = line.rfind(before_host); at != std::string::npos) {
    found.host = line.substr(at + before_host.size());
  }
  constexpr std::size_t minutes = 16;  // "2026-11-27 23:58"
  constexpr std::size_t program = 24;  // after the milliseconds
  std::ifstream log(run.log());
  while (std::getline(log, line)) {
    if (line.size() > program && line.compare(program, 7, "solver ") == 0) found.until = line.substr(0, minutes);
  }
  return found;
}

std::vector<std::string> comments_in(const fs::path& file) { return CsvTable::read(file).comments; }

}  // namespace thalweg
