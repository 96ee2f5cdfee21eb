#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "case/reader/declarations.hpp"
#include "case/tables/table_list.hpp"
#include "common/particles.hpp"
#include "common/units.hpp"

namespace thalweg {

/// Visits a table whose members hold the defaults, and collects its declarations.
class Collector {
 public:
  explicit Collector(TableDeclaration table) : table_(std::move(table)) {}
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
    }
    added.default_text = fmt::format("\"{}\"", word_for(value));
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

/// The declarations of one table.
template <class Table>
TableDeclaration declare_table(TableForm form) {
  const TableHeading& heading = Table::heading;
  TableDeclaration declaration{heading.name, form, heading.meaning, heading.note, false, {}, nullptr};
  if constexpr (requires { &Table::explain_further; }) declaration.explain_further = &Table::explain_further;
  Collector collector(std::move(declaration));
  Table table;
  if constexpr (requires { &Table::without_defaults; }) table = Table::without_defaults();
  table.describe(collector);
  declaration = collector.take();
  // A single table with a key that the case has to give cannot be left out either.
  const bool needs_a_key =
      form == TableForm::single && std::any_of(declaration.keys.begin(), declaration.keys.end(),
                                               [](const KeyDeclaration& key) { return key.required; });
  declaration.indispensable = heading.indispensable || needs_a_key;
  return declaration;
}

/// The declarations of all tables of C, a struct like Case (case/tables/table_list.hpp).
template <class C>
Declarations declare_tables() {
  Declarations tables;
  C defaults;
  for_each_table(defaults, [&]<class Member>(Member&) {
    using Traits = TableTraits<Member>;
    tables.push_back(declare_table<typename Traits::Entry>(Traits::form));
  });
  return tables;
}

}  // namespace thalweg
