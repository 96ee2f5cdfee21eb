#include "gencase/survey_reader.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/convex_hull_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/plain_file.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string extension_of(const fs::path& file) { return small(file.extension().string()); }

SurveyFile read_table(const fs::path& file) {
  const CsvTable table = CsvTable::read(file);
  SurveyFile survey;
  const std::vector<double> x = table.numbers("x", "m");
  const std::vector<double> z = table.numbers("z", "m");
  survey.has_y = table.has("y");
  const std::vector<double> y = survey.has_y ? table.numbers("y", "m") : std::vector<double>(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3& p = survey.points.emplace_back(x[i], y[i], z[i]);
    if (!p.allFinite())
      throw InputError(table.where(i) + ": a coordinate is missing; give every point all of them, or remove the row");
    const std::string where = table.where(i);
    survey.lines.push_back(number_of<int>(where.substr(where.rfind(':') + 1)).value_or(0));
  }
  return survey;
}

/// The lines of a text with their numbers, without a byte order mark.
class TextLines {
 public:
  explicit TextLines(const fs::path& file) : file_(file), stream_(file, std::ios::binary) {
    if (!stream_) throw InputError(file.string() + ": cannot be opened; check the name and the permissions");
  }
  bool next(std::string& line) {
    if (!std::getline(stream_, line)) return false;
    if (++number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    return true;
  }
  [[nodiscard]] int number() const { return number_; }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), number_, what));
  }
  /// The number that is the word. Decimal commas are asked about, never guessed.
  [[nodiscard]] double number(std::string_view word) const {
    const auto value = number_of<double>(word);
    if (value && std::isfinite(*value)) return *value;
    std::string pointed(word);
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    if (pointed != word && number_of<double>(pointed))
      refuse(fmt::format("\"{}\" has a decimal comma; write {} in the whole file", shown(word), shown(pointed)));
    refuse(fmt::format("\"{}\" is no number; correct or remove the line", shown(word)));
  }

 private:
  fs::path file_;
  std::ifstream stream_;
  int number_ = 0;
};

/// The words of a line between blanks, semicolons, and commas that no digit follows at once or that stand alone.
std::vector<std::string_view> cells_of(std::string_view line, bool commas) {
  std::vector<std::string_view> cells;
  const auto parts = [&](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ';' || (commas && c == ','); };
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && parts(line[at])) ++at;
    const std::size_t begin = at;
    while (at < line.size() && !parts(line[at])) ++at;
    if (at > begin) cells.push_back(line.substr(begin, at - begin));
  }
  return cells;
}

SurveyFile read_points(const fs::path& file) {
  SurveyFile survey;
  TextLines lines(file);
  std::size_t wider = 0;
  bool heading = false;
  for (std::string line; lines.next(line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    std::vector<std::string_view> cells = cells_of(line, false);
    if (cells.size() < 3) cells = cells_of(line, true);
    if (survey.points.empty() && !heading && !cells.empty() && std::isalpha(static_cast<unsigned char>(cells[0][0]))) {
      heading = true;
      continue;
    }
    if (cells.size() < 3)
      lines.refuse(fmt::format("a line of {} numbers; give x, y and z on each, separated by blanks", cells.size()));
    wider += cells.size() > 3;
    Vec3& point = survey.points.emplace_back();
    for (int axis = 0; axis < 3; ++axis) point[axis] = lines.number(cells[static_cast<std::size_t>(axis)]);
    survey.lines.push_back(lines.number());
  }
  survey.remarks.push_back(fmt::format("{} points read as x, y, z in metres times `scale`", survey.points.size()));
  if (heading) survey.remarks.emplace_back("its first line is taken for a heading");
  if (wider > 0)
    survey.remarks.push_back(fmt::format("{} lines have more than three numbers; the rest is left out", wider));
  return survey;
}

/// The head of an ESRI ASCII grid: a word and a number on each line, until a line begins with a number.
struct GridHead {
  std::map<std::string, double> values;
  [[nodiscard]] std::optional<double> value(const std::string& word) const {
    const auto found = values.find(word);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] double value(const TextLines& lines, const std::string& word) const {
    const auto found = value(word);
    if (!found) lines.refuse(fmt::format("the grid's head has no \"{}\"; export it as an ESRI ASCII grid", word));
    return *found;
  }
  /// Middle of the first cell along an axis.
  [[nodiscard]] double first(const TextLines& lines, const std::string& axis, double cell) const {
    const auto center = value(axis + "llcenter");
    return center ? *center : value(lines, axis + "llcorner") + 0.5 * cell;
  }
};

/// Some programs write "nan" where a grid has no height.
bool is_gap(std::string_view word) { return small(std::string(word)) == "nan"; }

SurveyFile read_grid(const fs::path& file) {
  SurveyFile survey;
  TextLines lines(file);
  GridHead head;
  std::string line;
  std::vector<std::string_view> cells;
  while (lines.next(line)) {
    cells = cells_of(line, false);
    if (cells.empty()) continue;
    if (!std::isalpha(static_cast<unsigned char>(cells[0][0]))) break;
    if (cells.size() != 2) lines.refuse("the grid's head has a line that is no word and number; export it again");
    double& value = head.values[small(std::string(cells[0]))];
    value = is_gap(cells[1]) ? std::numeric_limits<double>::quiet_NaN() : lines.number(cells[1]);
  }
  const double columns = head.value(lines, "ncols");
  const double rows = head.value(lines, "nrows");
  const double cell = head.value(lines, "cellsize");
  const auto counts = [](double number) { return number >= 1 && number <= 1e9 && std::floor(number) == number; };
  if (!counts(columns) || !counts(rows) || !(cell > 0))
    lines.refuse("ncols and nrows need whole numbers from 1, cellsize a number above 0; export the grid again");
  const double x = head.first(lines, "x", cell);
  const double y = head.first(lines, "y", cell);
  const double missing = head.value("nodata_value").value_or(-9999);
  std::size_t gaps = 0;
  double count = 0;
  // Rows run from north to south; a row may be broken into several lines.
  for (bool more = true; more; more = lines.next(line)) {
    for (const std::string_view word : cells_of(line, false)) {
      const double height = is_gap(word) ? missing : lines.number(word);
      const double row = std::floor(count / columns);
      const double column = count++ - row * columns;
      if (is_gap(word) || height == missing)
        ++gaps;
      else
        survey.points.emplace_back(x + column * cell, y + (rows - 1 - row) * cell, height);
      if (survey.lines.size() < survey.points.size()) survey.lines.push_back(lines.number());
    }
  }
  if (count != rows * columns)
    lines.refuse(fmt::format("the grid ends after {:.0f} heights, its head announces {:.0f} x {:.0f}; export it again",
                             count, columns, rows));
  survey.remarks.push_back(fmt::format("a grid of {:.0f} x {:.0f} heights, in metres times `scale`", columns, rows));
  if (gaps > 0) survey.remarks.push_back(fmt::format("{} cells without a height are left out", gaps));
  return survey;
}

}  // namespace

bool is_survey(const fs::path& file) {
  constexpr std::array extensions{".csv", ".xyz", ".txt", ".asc", ".grd"};
  return std::find(extensions.begin(), extensions.end(), extension_of(file)) != extensions.end();
}

SurveyFile read_survey(const fs::path& file) {
  require_plain_file(file, "a survey");
  if (!fs::exists(file))
    throw InputError(file.string() + ": there is no such file; check the name, which is relative to the case's folder");
  const std::string extension = extension_of(file);
  const bool lists = extension == ".xyz" || extension == ".txt";
  SurveyFile survey = extension == ".csv" ? read_table(file) : lists ? read_points(file) : read_grid(file);
  constexpr double farthest = 1e12;  // millimetres from the equator to a pole are 1e10
  for (std::size_t i = 0; i < survey.points.size(); ++i) {
    if (survey.points[i].cwiseAbs().maxCoeff() <= farthest) continue;
    throw InputError(fmt::format("{}:{}: a coordinate is larger than {:g}; correct it, or remove the row",
                                 file.string(), survey.lines[i], farthest));
  }
  return survey;
}

Repeated merge_repeated(std::vector<Vec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto same = [&](auto i, auto j) { return points[i].x() == points[j].x() && points[i].y() == points[j].y(); };
  std::sort(order.begin(), order.end(), [&](auto i, auto j) {
    return std::tuple(points[i].x(), points[i].y(), i) < std::tuple(points[j].x(), points[j].y(), j);
  });
  Repeated repeated;
  std::vector<bool> dropped(points.size(), false);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    std::size_t low = order[begin];
    std::size_t high = low;
    double sum = 0;
    for (end = begin; end < order.size() && same(order[begin], order[end]); ++end) {
      const std::size_t i = order[end];
      sum += points[i].z();
      dropped[i] = end > begin;
      if (points[i].z() < points[low].z()) low = i;
      if (points[i].z() > points[high].z()) high = i;
    }
    const double difference = points[high].z() - points[low].z();
    if (difference == 0) continue;
    ++repeated.places;
    if (difference > repeated.largest)
      repeated = {repeated.places, difference, std::min(low, high), std::max(low, high)};
    points[order[begin]].z() = sum / static_cast<double>(end - begin);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!dropped[i]) points[kept++] = points[i];
  points.resize(kept);
  return repeated;
}

std::vector<Vec3> averaged(const std::vector<Vec3>& points, double square) {
  Vec3 lower = points.front();
  for (const Vec3& p : points) lower = lower.cwiseMin(p);
  const auto square_of = [&](const Vec3& p) {
    return std::pair(std::floor((p.x() - lower.x()) / square), std::floor((p.y() - lower.y()) / square));
  };
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](auto i, auto j) { return std::pair(square_of(points[i]), i) < std::pair(square_of(points[j]), j); });
  std::vector<Vec3> means;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Vec3 sum = Vec3::Zero();
    for (end = begin; end < order.size() && square_of(points[order[end]]) == square_of(points[order[begin]]); ++end)
      sum += points[order[end]];
    means.emplace_back(sum / static_cast<double>(end - begin));
  }
  std::vector<Kernel::Point_3> outline;
  std::vector<Kernel::Point_3> all;
  all.reserve(points.size());
  for (const Vec3& p : points) all.emplace_back(p.x(), p.y(), p.z());
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(outline), CGAL::Projection_traits_xy_3<Kernel>());
  for (const auto& p : outline) means.emplace_back(p.x(), p.y(), p.z());
  merge_repeated(means);
  return means;
}

}  // namespace thalweg::gencase
