#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/check_context.hpp"
#include "case/nearest.hpp"
#include "case/reader/mistakes.hpp"
#include "case/reader/toml.hpp"
#include "case/tables/table.hpp"
#include "common/error.hpp"
#include "common/particles.hpp"
#include "common/units.hpp"

namespace thalweg {

/// Visits the struct of a table and fills it from the file. case/tables/table.hpp describes the methods; each throws
/// InputError "where: what is wrong; what to do".
class TableReader {
 public:
  TableReader(const toml::table* table, std::string path, int dimension, CaseOrigins& origins)
      : table_(table), path_(std::move(path)), dimension_(dimension), origins_(origins) {
    if (table_ != nullptr) origins_.given[path_] = where_is(*table_, origins_.file);
  }

  void quantity(const char* key, double& value, const char* unit, double low, double high, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::isnan(value) ? missing(key, fmt::format("\"... {}\"", usual_unit(unit))) : void();
    value = parse(*node, full(key), unit, low, high);
  }

  void number(const char* key, double& value, double low, double high, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::isnan(value) ? missing(key, "...") : void();
    if (!node->is_number()) {
      reject_case(where(*node), fmt::format("{} must be a plain number", full(key)),
                  "write it without quotes and unit");
    }
    value = node->value<double>().value();
    if (!(value >= low && value <= high)) {
      reject_case(where(*node), fmt::format("{} = {} is out of range", full(key), value),
                  fmt::format("give {} to {}", low, high));
    }
  }

  void integer(const char* key, int& value, int low, int high, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    if (!node->is_integer())
      reject_case(where(*node), fmt::format("{} must be a whole number", full(key)),
                  "write it without quotes and point");
    const std::int64_t given = node->value<std::int64_t>().value();
    if (given < low || given > high) {
      reject_case(where(*node), fmt::format("{} = {} is out of range", full(key), given),
                  fmt::format("give {} to {}", low, high));
    }
    value = static_cast<int>(given);
  }

  void flag(const char* key, bool& value, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    if (!node->is_boolean())
      reject_case(where(*node), fmt::format("{} must be true or false", full(key)), "write it without quotes");
    value = node->value<bool>().value();
  }

  void text(const char* key, std::string& value, const char*) {
    if (const toml::node* node = find(key)) value = text_of(*node, full(key));
  }

  void texts(const char* key, std::vector<std::string>& values, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    values.clear();
    for (const toml::node& entry : array_of(*node, key, "[\"...\", \"...\"]"))
      values.push_back(text_of(entry, full(key)));
  }

  void point(const char* key, Vec3& value, const char* unit, const char*) {
    const char* axes = dimension_ == 2 ? "[x, z]" : "[x, y, z]";
    const toml::node* node = find(key);
    if (node == nullptr) {
      const std::vector<std::string> entries(static_cast<std::size_t>(dimension_), fmt::format("\"... {}\"", unit));
      return std::isnan(value.x()) ? missing(key, fmt::format("[{}]", fmt::join(entries, ", "))) : void();
    }
    const toml::array& entries = array_of(*node, key, axes);
    if (entries.size() != static_cast<std::size_t>(dimension_)) {
      reject_case(where(*node), fmt::format("{} has {} entries", full(key), entries.size()),
                  fmt::format("dimension = {} needs {}: {}", dimension_, dimension_, axes));
    }
    constexpr double largest = 1e9;
    const auto component = [&](std::size_t i) { return parse(entries[i], full(key), unit, -largest, largest); };
    value = dimension_ == 2 ? Vec3(component(0), 0, component(1)) : Vec3(component(0), component(1), component(2));
  }

  void direction(const char* key, Vec3& value, const char*) {
    const char* axes = dimension_ == 2 ? "[x, z]" : "[x, y, z]";
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array& entries = array_of(*node, key, axes);
    if (entries.size() != static_cast<std::size_t>(dimension_)) {
      reject_case(where(*node), fmt::format("{} has {} entries", full(key), entries.size()),
                  fmt::format("dimension = {} needs {}: {}", dimension_, dimension_, axes));
    }
    value = Vec3::Zero();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto number = entries[i].value_exact<double>();
      const auto whole = entries[i].value_exact<std::int64_t>();
      if ((!number || !std::isfinite(*number)) && !whole) {
        reject_case(where(entries[i]), fmt::format("{} is a direction and takes plain numbers", full(key)),
                    "write it without quotes and unit");
      }
      value[dimension_ == 2 && i == 1 ? 2 : static_cast<Eigen::Index>(i)] =
          number ? *number : static_cast<double>(*whole);
    }
    if (!(value.norm() > 0)) {
      reject_case(where(*node), fmt::format("{} is zero", full(key)), "give one of its numbers another value");
    }
  }

  void quantities(const char* key, std::vector<double>& values, const char* unit, double low, double high,
                  const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    values.clear();
    for (const toml::node& entry : array_of(*node, key, fmt::format("[\"... {0}\", \"... {0}\"]", unit))) {
      values.push_back(parse(entry, full(key), unit, low, high));
    }
  }

  void polygon(const char* key, std::vector<Eigen::Vector2d>& corners, const char* unit, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    corners.clear();
    const std::string example = fmt::format("[[\"... {0}\", \"... {0}\"], ...]", unit);
    constexpr double largest = 1e9;
    for (const toml::node& entry : array_of(*node, key, example)) {
      const toml::array& pair = array_of(entry, key, example);
      if (pair.size() != 2)
        reject_case(where(entry), fmt::format("{} has a corner of {} entries", full(key), pair.size()),
                    fmt::format("write {} = {}", key, example));
      corners.emplace_back(parse(pair[0], full(key), unit, -largest, largest),
                           parse(pair[1], full(key), unit, -largest, largest));
    }
  }

  template <class E>
  void choice(const char* key, E& value, const char*) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const std::string word = text_of(*node, full(key));
    std::vector<std::string> known;
    for (const Choice<E>& candidate : choices(E{})) {
      known.emplace_back(candidate.name);
      if (word == candidate.name) {
        value = candidate.value;
        return;
      }
    }
    const auto near = nearest(word, known);
    reject_case(where(*node), fmt::format("{} = \"{}\" is unknown", full(key), word),
                near ? fmt::format("did you mean \"{}\"? The words are {}", *near, fmt::join(known, ", "))
                     : fmt::format("the words are {}", fmt::join(known, ", ")));
  }

 private:
  // Nobody writes angles in radians.
  static std::string_view usual_unit(std::string_view si_unit) { return si_unit == "rad" ? "deg" : si_unit; }

  [[nodiscard]] std::string full(const char* key) const { return fmt::format("{}.{}", path_, key); }
  [[nodiscard]] std::string where(const toml::node& node) const { return where_is(node, origins_.file); }

  const toml::node* find(const char* key) {
    const toml::node* node = table_ != nullptr ? table_->get(key) : nullptr;
    if (node != nullptr) origins_.given[full(key)] = where(*node);
    return node;
  }

  void missing(const char* key, const std::string& example) const {
    throw MissingKey(
        fmt::format("{}: {} is missing; add {} = {} to [{}]", origins_.where(path_), full(key), key, example, path_),
        path_);
  }

  [[nodiscard]] std::string text_of(const toml::node& node, const std::string& name) const {
    if (!node.is_string()) reject_case(where(node), fmt::format("{} must be a text", name), "put it in quotes");
    return node.as_string()->get();
  }

  [[nodiscard]] const toml::array& array_of(const toml::node& node, const char* key, const std::string& example) const {
    if (!node.is_array()) {
      reject_case(where(node), fmt::format("{} must be a list", full(key)), fmt::format("write {} = {}", key, example));
    }
    return *node.as_array();
  }

  [[nodiscard]] double parse(const toml::node& node, const std::string& name, const char* unit, double low,
                             double high) const {
    if (node.is_number()) {
      const double number = node.value<double>().value();
      reject_case(where(node), fmt::format("{} = {} has no unit", name, number),
                  fmt::format("write it as a text, such as \"{} {}\"", number, unit));
    }
    const std::string written = text_of(node, name);
    double value = 0;
    try {
      value = parse_quantity(written, unit);
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {}: {}", where(node), name, error.what()));
    }
    if (value < low || value > high) {
      reject_case(where(node), fmt::format("{} = \"{}\" is out of range", name, written),
                  fmt::format("give {} to {}", format_quantity(low, unit), format_quantity(high, unit)));
    }
    return value;
  }

  const toml::table* table_;
  std::string path_;
  int dimension_;
  CaseOrigins& origins_;
};

}  // namespace thalweg
