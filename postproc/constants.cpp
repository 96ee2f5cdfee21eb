#include "postproc/constants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <type_traits>

#include "case/tables/table_list.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

// A visitor of describe() that writes every value as text.
class ValueList {
 public:
  explicit ValueList(int dimension) : dimension_(dimension) {}

  void quantity(const char* key, double& value, const char* unit, double, double, const char* sentence) {
    add(key, format_quantity(value, unit), sentence);
  }
  void number(const char* key, double& value, double, double, const char* sentence) {
    add(key, fmt::format("{:g}", value), sentence);
  }
  void integer(const char* key, int& value, double, double, const char* sentence) {
    add(key, fmt::format("{}", value), sentence);
  }
  void flag(const char* key, bool& value, const char* sentence) { add(key, value ? "yes" : "no", sentence); }
  void text(const char* key, std::string& value, const char* sentence) { add(key, value, sentence); }
  void texts(const char* key, std::vector<std::string>& values, const char* sentence) {
    add(key, fmt::format("{}", fmt::join(values, ", ")), sentence);
  }
  void point(const char* key, Vec3& value, const char* unit, const char* sentence) {
    std::string text = format_quantity(value.x(), unit);
    if (dimension_ == 3) text += ", " + format_quantity(value.y(), unit);
    add(key, text + ", " + format_quantity(value.z(), unit), sentence);
  }
  void direction(const char* key, Vec3& value, const char* sentence) {
    add(key, fmt::format("{:g}, {:g}, {:g}", value.x(), value.y(), value.z()), sentence);
  }
  void quantities(const char* key, std::vector<double>& values, const char* unit, double, double,
                  const char* sentence) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(format_quantity(value, unit));
    add(key, fmt::format("{}", fmt::join(texts, ", ")), sentence);
  }
  void polygon(const char* key, std::vector<Eigen::Vector2d>& corners, const char* unit, const char* sentence) {
    std::vector<std::string> texts;
    for (const Eigen::Vector2d& corner : corners) {
      texts.push_back(fmt::format("({}, {})", format_quantity(corner.x(), unit), format_quantity(corner.y(), unit)));
    }
    add(key, fmt::format("{}", fmt::join(texts, ", ")), sentence);
  }
  template <class E>
  void choice(const char* key, E& value, const char* sentence) {
    for (const Choice<E>& candidate : choices(E{})) {
      if (candidate.value == value) add(key, candidate.name, fmt::format("{} Here: {}.", sentence, candidate.sentence));
    }
  }

  std::vector<Constant> rows;

 private:
  void add(const char* key, std::string value, std::string sentence) {
    rows.push_back({key, value.empty() ? "–" : std::move(value), std::move(sentence), false});
  }
  int dimension_;
};

template <class Table>
std::vector<Constant> values_of(Table& table, int dimension) {
  ValueList given(dimension);
  table.describe(given);
  Table untouched;
  ValueList defaults(dimension);
  untouched.describe(defaults);
  for (std::size_t i = 0; i < given.rows.size(); ++i) {
    given.rows[i].is_default = given.rows[i].value == defaults.rows[i].value;
  }
  return given.rows;
}

// A shape in one row: its kind, role and material as the value, its place as the meaning.
Constant shape_in_a_row(Shape& shape, int dimension) {
  std::vector<std::string> what;
  std::vector<std::string> where;
  for (const Constant& row : values_of(shape, dimension)) {
    if (row.key == "name" || row.value == "–" || !shape.uses_key(row.key, dimension)) continue;
    if (row.is_default && row.key == "thickness") continue;  // the default is a word, not the 0 that stands for it
    const bool speaks_for_itself = row.key == "kind" || row.key == "role" || row.key == "material";
    if (speaks_for_itself) {
      what.push_back(row.value);
    } else {
      where.push_back(row.key + " " + row.value);
    }
  }
  return {shape.name, fmt::format("{}", fmt::join(what, ", ")), fmt::format("{}", fmt::join(where, "; ")), false};
}

// A visitor that finds the choices of a table; "off" and "none" are the words model parts use for their absence.
class SwitchList {
 public:
  template <class E>
  void choice(const char* key, E& value, const char*) {
    for (const Choice<E>& candidate : choices(E{})) {
      if (candidate.value != value) continue;
      const std::string word = candidate.name;
      const bool on = word != "off" && word != "none";
      found.push_back({on ? fmt::format("{} = {}", key, candidate.name) : key, on, candidate.sentence});
    }
  }
  void flag(const char* key, bool& value, const char* sentence) { found.push_back({key, value, sentence}); }
  template <class... Anything>
  void quantity(Anything&&...) {}
  template <class... Anything>
  void quantities(Anything&&...) {}
  template <class... Anything>
  void number(Anything&&...) {}
  template <class... Anything>
  void integer(Anything&&...) {}
  template <class... Anything>
  void text(Anything&&...) {}
  template <class... Anything>
  void texts(Anything&&...) {}
  template <class... Anything>
  void point(Anything&&...) {}

  std::vector<Switch> found;
};

}  // namespace

std::vector<ConstantTable> list_constants(const Case& resolved) {
  Case copy = resolved;  // describe() hands out references to the values
  const int dimension = copy.dimension();
  std::vector<ConstantTable> tables;
  for_each_entry(copy, [&]<class Table>(const EntryPlace& place, Table& table) {
    if constexpr (std::is_same_v<Table, Shape>) {
      if (tables.back().name != place.heading.name) tables.push_back({place.heading.name, {}});
      tables.back().rows.push_back(shape_in_a_row(table, dimension));
    } else {
      tables.push_back({place.path(), values_of(table, dimension)});
    }
  });
  return tables;
}

std::vector<Switch> list_switches(const Case& resolved) {
  Case copy = resolved;
  SwitchList model;
  copy.model.describe(model);
  std::vector<Switch> all = model.found;

  all.push_back({"density diffusion", copy.numerics.density_diffusion > 0, "Between particles of one phase."});
  all.push_back(
      {"artificial viscosity", copy.numerics.artificial_viscosity > 0, "Between approaching particles of one phase."});
  for (auto& [name, sediment] : copy.sediments) {
    all.push_back({"cohesion of " + name, sediment.cohesion > 0, "Yield stress without any effective pressure."});
  }
  std::vector<std::string> directions = copy.domain.periodic;
  all.push_back(
      {"periodic directions", !directions.empty(),
       directions.empty() ? "The domain ends at its walls." : fmt::format("{}", fmt::join(directions, ", "))});
  return all;
}

}  // namespace thalweg
