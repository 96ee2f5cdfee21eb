#include "common/profile.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/shown.hpp"

namespace thalweg {
namespace {

// The curves of a profile in the order of the file.
struct Curve {
  const char* name;
  std::vector<double> Profile::*values;
};
constexpr Curve curves[] = {{"free_surface", &Profile::free_surface},
                            {"bed", &Profile::bed},
                            {"moving_bed", &Profile::moving_bed},
                            {"floor", &Profile::floor}};

constexpr const char* known_columns = "x [m], free_surface [m], bed [m], moving_bed [m], floor [m]";

}  // namespace

void write_profile(const std::filesystem::path& file, const Profile& profile,
                   const std::vector<std::string>& comments) {
  std::vector<CsvColumn> columns{{"x", "m"}};
  std::vector<const std::vector<double>*> values{&profile.x};
  for (const Curve& curve : curves) {
    const std::vector<double>& curve_values = profile.*curve.values;
    if (curve_values.empty()) continue;
    if (curve_values.size() != profile.x.size()) {
      throw RunError(fmt::format("{}: cannot be written: {} has {} values for {} of x", file.string(), curve.name,
                                 curve_values.size(), profile.x.size()));
    }
    columns.push_back({curve.name, "m"});
    values.push_back(&curve_values);
  }
  CsvTable table(columns);
  table.comments = comments;
  for (std::size_t row = 0; row < profile.x.size(); ++row) {
    std::vector<std::string> cells;
    for (const std::vector<double>* column : values) cells.push_back(csv_number((*column)[row]));
    table.add_row(std::move(cells));
  }
  table.write(file);
}

Profile read_profile(const std::filesystem::path& file) {
  const CsvTable table = CsvTable::read(file);
  Profile profile;
  profile.x = table.numbers("x", "m");
  for (const CsvColumn& column : table.columns()) {
    bool known = column.name == "x";
    for (const Curve& curve : curves) {
      if (column.name != curve.name) continue;
      profile.*curve.values = table.numbers(column.name, "m");
      known = true;
    }
    if (!known) {
      throw InputError(fmt::format("{}: unknown column \"{}\"; a profile has {}", table.where(),
                                   shown(column.heading()), known_columns));
    }
  }
  for (std::size_t row = 0; row < profile.x.size(); ++row) {
    if (!std::isfinite(profile.x[row])) {
      throw InputError(fmt::format("{}: x is missing; every row needs one", table.where(row)));
    }
    if (row > 0 && profile.x[row] <= profile.x[row - 1]) {
      throw InputError(fmt::format("{}: x = {} does not increase; sort the rows by x and keep one for each",
                                   table.where(row), profile.x[row]));
    }
  }
  return profile;
}

std::string profile_file_name(double time) {
  std::string text = fmt::format("{:.6f}", time);
  while (text.ends_with('0') && text.size() - text.find('.') > 4) text.pop_back();  // three decimals stay
  return "t" + text + ".csv";
}

std::optional<double> time_of_profile(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  if (file.extension() != ".csv" || stem.size() < 2 || stem.front() != 't') return std::nullopt;
  double time = 0;
  const char* const end = stem.data() + stem.size();
  const auto parsed = std::from_chars(stem.data() + 1, end, time, std::chars_format::fixed);
  if (parsed.ec != std::errc{} || parsed.ptr != end || !std::isfinite(time)) return std::nullopt;
  return time;
}

}  // namespace thalweg
