#pragma once

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "case/tables/table_list.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// The text in quotes, as TOML.
std::string toml_text(const std::string& text);

/// The shortest digits that read back as the same number.
inline std::string quantity_text(double value, const char* unit) { return fmt::format("\"{} {}\"", value, unit); }

/// Visits a table and prints the keys that `uses(key)` accepts.
class TableWriter {
 public:
  using UsesKey = std::function<bool(const char*)>;
  TableWriter(std::ostream& to, int dimension, UsesKey uses) : to_(to), dimension_(dimension), uses_(std::move(uses)) {}

  void quantity(const char* key, double& value, const char* unit, double, double, const char*) {
    if (!std::isnan(value)) line(key, quantity_text(value, unit));
  }
  void number(const char* key, double& value, double, double, const char*) {
    if (!std::isnan(value)) line(key, fmt::format("{}", value));
  }
  void integer(const char* key, int& value, int, int, const char*) { line(key, fmt::format("{}", value)); }
  void flag(const char* key, bool& value, const char*) { line(key, value ? "true" : "false"); }
  void text(const char* key, std::string& value, const char*) { line(key, toml_text(value)); }
  void texts(const char* key, std::vector<std::string>& values, const char*) {
    std::vector<std::string> entries;
    for (const std::string& value : values) entries.push_back(toml_text(value));
    list(key, entries);
  }
  void point(const char* key, Vec3& value, const char* unit, const char*) {
    if (value.hasNaN()) return;
    std::vector<std::string> entries{quantity_text(value.x(), unit), quantity_text(value.z(), unit)};
    if (dimension_ == 3) entries.insert(entries.begin() + 1, quantity_text(value.y(), unit));
    list(key, entries);
  }
  void direction(const char* key, Vec3& value, const char*) {
    if (dimension_ == 2) return line(key, fmt::format("[{}, {}]", value.x(), value.z()));
    line(key, fmt::format("[{}, {}, {}]", value.x(), value.y(), value.z()));
  }
  void quantities(const char* key, std::vector<double>& values, const char* unit, double, double, const char*) {
    std::vector<std::string> entries;
    for (const double value : values) entries.push_back(quantity_text(value, unit));
    list(key, entries);
  }
  void polygon(const char* key, std::vector<Eigen::Vector2d>& corners, const char* unit, const char*) {
    std::vector<std::string> entries;
    for (const Eigen::Vector2d& corner : corners)
      entries.push_back(fmt::format("[{}, {}]", quantity_text(corner.x(), unit), quantity_text(corner.y(), unit)));
    list(key, entries);
  }
  template <class E>
  void choice(const char* key, E& value, const char*) {
    line(key, toml_text(word_for(value)));
  }

 private:
  void line(const char* key, const std::string& value) {
    if (uses_(key)) fmt::print(to_, "{} = {}\n", key, value);
  }
  void list(const char* key, const std::vector<std::string>& entries) {
    line(key, fmt::format("[{}]", fmt::join(entries, ", ")));
  }

  std::ostream& to_;
  int dimension_;
  UsesKey uses_;
};

/// Writes all tables of `values`, a struct like Case (case/tables/table_list.hpp), with every key that means something;
/// read_case reads them.
template <class C>
void write_tables(std::ostream& to, C values) {  // a copy, because describe() hands out references
  const int dimension = values.dimension();
  for_each_entry(values, [&]<class T>(const EntryPlace& place, T& table) {
    switch (place.form) {
      case TableForm::single:
        fmt::print(to, "\n[{}]\n", place.heading.name);
        break;
      case TableForm::repeated:
        fmt::print(to, "\n[[{}]]\n", place.heading.name);
        break;
      case TableForm::by_name:
        fmt::print(to, "\n[{}.{}]\n", group_of(place.heading.name), toml_text(place.name));
        break;
    }
    TableWriter writer(to, dimension, [&](const char* key) {
      if constexpr (requires { &T::uses_key; }) return table.uses_key(key, dimension);
      return static_cast<void>(key), true;
    });
    table.describe(writer);
  });
}

}  // namespace thalweg
