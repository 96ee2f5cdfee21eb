#include "case/reader/keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case/reader/tables.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

// Visits a table whose members hold the defaults.
class Collector {
 public:
  explicit Collector(const TableHeading& heading) : table_{heading.name, heading.meaning, {}} {}
  TableDeclaration take() { return std::move(table_); }

  void quantity(const char* key, double& value, const char* unit, double low, double high, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::quantity, sentence);
    range(added, unit, low, high);
    default_number(added, value, format_quantity(value, unit));
  }
  void number(const char* key, double& value, double low, double high, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::number, sentence);
    range(added, "", low, high);
    default_number(added, value, fmt::format("{}", value));
  }
  void integer(const char* key, int& value, int low, int high, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::integer, sentence);
    range(added, "", low, high);
    added.default_text = fmt::format("{}", value);
  }
  void flag(const char* key, bool& value, const char* sentence) {
    add(key, KeyKind::flag, sentence).default_text = value ? "true" : "false";
  }
  void text(const char* key, std::string& value, const char* sentence) {
    add(key, KeyKind::text, sentence).default_text = fmt::format("\"{}\"", value);
  }
  void texts(const char* key, std::vector<std::string>& value, const char* sentence) {
    add(key, KeyKind::texts, sentence).default_text =
        value.empty() ? "[]" : fmt::format("[\"{}\"]", fmt::join(value, "\", \""));
  }
  void point(const char* key, Vec3& value, const char* unit, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::point, sentence);
    added.unit = unit;
    added.required = std::isnan(value.x());
    if (!added.required) {
      added.default_text = fmt::format("[\"{}\", \"{}\", \"{}\"]", format_quantity(value.x(), unit),
                                       format_quantity(value.y(), unit), format_quantity(value.z(), unit));
    }
  }
  void direction(const char* key, Vec3& value, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::direction, sentence);
    added.required = std::isnan(value.x());
    if (!added.required) added.default_text = fmt::format("[{}, {}, {}]", value.x(), value.y(), value.z());
  }
  void quantities(const char* key, std::vector<double>&, const char* unit, double low, double high,
                  const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::quantities, sentence);
    range(added, unit, low, high);
    added.default_text = "[]";
  }
  void polygon(const char* key, std::vector<Eigen::Vector2d>&, const char* unit, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::polygon, sentence);
    added.unit = unit;
    added.default_text = "[]";
  }
  template <class E>
  void choice(const char* key, E& value, const char* sentence) {
    KeyDeclaration& added = add(key, KeyKind::choice, sentence);
    for (const Choice<E>& word : choices(E{})) {
      added.words.emplace_back(word.name);
      added.word_sentences.emplace_back(word.sentence);
      if (word.value == value) added.default_text = fmt::format("\"{}\"", word.name);
    }
  }

 private:
  KeyDeclaration& add(const char* key, KeyKind kind, const char* sentence) {
    KeyDeclaration& added = table_.keys.emplace_back();
    added.table = table_.name;
    added.name = key;
    added.kind = kind;
    added.sentence = sentence;
    return added;
  }
  static void range(KeyDeclaration& key, const char* unit, double low, double high) {
    key.unit = unit;
    key.low = low;
    key.high = high;
  }
  static void default_number(KeyDeclaration& key, double value, const std::string& text) {
    key.required = std::isnan(value);
    if (!key.required) key.default_text = text;
  }

  TableDeclaration table_;
};

template <class Table>
TableDeclaration collect(const TableHeading& heading, Table& table) {
  Collector collector(heading);
  table.describe(collector);
  return collector.take();
}

std::vector<TableDeclaration> collect_all() {
  std::vector<TableDeclaration> tables;
  Case defaults;
  // A shape's geometry has no default; which of these keys it needs depends on its kind.
  Shape shape;
  shape.from = shape.to = shape.center = Vec3::Constant(required);
  shape.radius = required;
  Motion motion;
  motion.direction = motion.center = motion.axis = Vec3::Constant(required);
  motion.amplitude = motion.period = required;
  Gauge gauge;
  gauge.at = gauge.from = gauge.to = Vec3::Constant(required);
  ProfileLine line;
  SedimentParameters sediment;
  for_each_table(
      defaults, [&](const TableHeading& heading, auto& table) { tables.push_back(collect(heading, table)); },
      [&] {
        tables.push_back(collect(shape_heading, shape));
        tables.push_back(collect(motion_heading, motion));
      },
      [&] { tables.push_back(collect(sediment_heading, sediment)); },
      [&] {
        tables.push_back(collect(gauge_heading, gauge));
        tables.push_back(collect(line_heading, line));
      });
  return tables;
}

// Levenshtein's distance: fewest insertions, deletions and replacements that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string KeyDeclaration::full_name() const {
  return fmt::format("{}.{}", is_list() ? table.substr(1, table.size() - 2) : table, name);
}

const std::vector<TableDeclaration>& case_declarations() {
  static const std::vector<TableDeclaration> tables = collect_all();
  return tables;
}

const TableDeclaration* find_table(std::string_view name) {
  std::string_view wanted = name;
  if (wanted == "shape") wanted = shape_heading.name;
  if (wanted == "motion") wanted = motion_heading.name;
  if (wanted == "gauge") wanted = gauge_heading.name;
  if (wanted == "line") wanted = line_heading.name;
  if (wanted.starts_with("materials.") && wanted != water_heading.name) wanted = sediment_heading.name;
  for (const TableDeclaration& table : case_declarations()) {
    if (table.name == wanted) return &table;
  }
  return nullptr;
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 2) + 1;
  for (const std::string& candidate : candidates) {
    const bool is_beginning = word.size() > 1 && candidate.starts_with(word);  // "spac" means "spacing"
    const std::size_t distance = is_beginning ? 1 : edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace thalweg
