#include "case/reader/reference.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "case/field_words.hpp"
#include "case/nearest.hpp"
#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

std::string kind_text(const KeyDeclaration& key) {
  switch (key.kind) {
    case KeyKind::quantity:
      return key.unit;
    case KeyKind::number:
      return "number";
    case KeyKind::integer:
      return "whole number";
    case KeyKind::flag:
      return "true or false";
    case KeyKind::text:
      return "text";
    case KeyKind::texts:
      return "list of texts";
    case KeyKind::point:
      return fmt::format("point, {}", key.unit);
    case KeyKind::quantities:
      return fmt::format("list of {}", key.unit);
    case KeyKind::polygon:
      return fmt::format("list of pairs of {}", key.unit);
    case KeyKind::choice:
      return "word";
    case KeyKind::direction:
      return "list of numbers";
  }
  return {};
}

void explain_key(std::ostream& to, const KeyDeclaration& key, TableForm form) {
  fmt::print(to, "{}\n  {}", key.full_name(), kind_text(key));
  if (has_range(key)) fmt::print(to, ", {}", range_text(key));
  fmt::print(to, "; {}{}\n", key.required ? "" : "default ", default_text(key, form));
  fmt::print(to, "  {}\n", key.sentence);
  for (std::size_t i = 0; i < key.words.size(); ++i) {
    fmt::print(to, "    \"{}\": {}\n", key.words[i], key.word_sentences[i]);
  }
}

void explain_table(std::ostream& to, const TableDeclaration& table) {
  fmt::print(to, "{}  {}\n\n", table.title(), table.meaning);
  for (const KeyDeclaration& key : table.keys) explain_key(to, key, table.form);
  fmt::print(to, "\n");
}

std::string default_in_markdown(const KeyDeclaration& key, TableForm form) {
  if (!key.required) return fmt::format("`{}`", key.default_text);
  return form == TableForm::repeated ? "by kind" : "**required**";
}

void write_table_reference(std::ostream& markdown, const TableDeclaration& table) {
  fmt::print(markdown, "\n## `{}`\n\n{}\n\n", table.title(), table.meaning);
  if (!table.note.empty()) fmt::print(markdown, "{}\n\n", table.note);
  fmt::print(markdown, "| key | value | default | range | meaning |\n|---|---|---|---|---|\n");
  for (const KeyDeclaration& key : table.keys) {
    std::string meaning = key.sentence;
    for (std::size_t i = 0; i < key.words.size(); ++i) {
      meaning += fmt::format("<br>`\"{}\"`: {}", key.words[i], key.word_sentences[i]);
    }
    fmt::print(markdown, "| `{}` | {} | {} | {} | {} |\n", key.name, kind_text(key),
               default_in_markdown(key, table.form), range_text(key), meaning);
  }
}

// The form of an override for a key of a table that may occur several times: "`gauge.NAME.key`, …".
std::string overrides_with_names(const Declarations& tables) {
  std::vector<std::string> names;
  for (const TableDeclaration& table : tables) {
    switch (table.form) {
      case TableForm::single:
        break;
      case TableForm::repeated:
        names.push_back(fmt::format("`{}.NAME.key`", table.name));
        break;
      case TableForm::by_name:
        names.push_back(fmt::format("`{}.NAME.key`", group_of(table.name)));
        break;
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

bool has_range(const KeyDeclaration& key) {
  switch (key.kind) {
    case KeyKind::quantity:
    case KeyKind::quantities:
    case KeyKind::number:
    case KeyKind::integer:
      return true;
    case KeyKind::flag:
    case KeyKind::text:
    case KeyKind::texts:
    case KeyKind::point:
    case KeyKind::polygon:
    case KeyKind::choice:
    case KeyKind::direction:
      return false;
  }
  return false;
}

std::string range_text(const KeyDeclaration& key) {
  if (!has_range(key)) return {};
  if (key.unit.empty()) return fmt::format("{} to {}", key.low, key.high);
  return fmt::format("{} to {}", format_quantity(key.low, key.unit), format_quantity(key.high, key.unit));
}

std::string default_text(const KeyDeclaration& key, TableForm form) {
  if (!key.required) return key.default_text;
  return form == TableForm::repeated ? "required by some kinds" : "required";
}

namespace {

bool declares(const TableDeclaration* table, const std::string& key) {
  return table != nullptr && std::any_of(table->keys.begin(), table->keys.end(),
                                         [&](const KeyDeclaration& declared) { return declared.name == key; });
}

/// Prints the tables and keys of this name; false if there are none. An empty name means all.
bool explain_named(std::ostream& to, const std::string& key, const Declarations& tables) {
  bool found = false;
  const auto dot = key.rfind('.');
  const TableDeclaration* table_of_key = dot == std::string::npos ? nullptr : find_table(tables, key.substr(0, dot));
  const TableDeclaration* whole_table = find_table(tables, key);
  if (table_of_key == whole_table && declares(table_of_key, key.substr(dot + 1)))
    whole_table = nullptr;  // materials.NAME.KEY
  for (const TableDeclaration& table : tables) {
    if (key.empty() || whole_table == &table) {
      explain_table(to, table);
      found = true;
    }
    for (const KeyDeclaration& declared : table.keys) {
      const bool meant = key == declared.name || (table_of_key == &table && key.substr(dot + 1) == declared.name);
      if (!meant) continue;
      explain_key(to, declared, table.form);
      found = true;
    }
  }
  return found;
}

void explain_field_word(std::ostream& to, const FieldWord& entry, const Declarations& tables) {
  fmt::print(to, "{}\n\n", entry.answer);
  for (const std::string& key : entry.keys) {
    const TableDeclaration* table = find_table(tables, key);
    if (table == nullptr || table->name != key) {  // a table by name is found for "materials.<sediment>.porosity" too
      explain_named(to, key, tables);
      continue;
    }
    fmt::print(to, "{}\n  {}\n  keys: {}\n  `thalweg explain {}` tells them all\n", table->title(), table->meaning,
               fmt::join(table->key_names(), ", "), key);
  }
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// After a key's own lines: the keys that carry its name in theirs, as grain_density carries density.
void explain_relatives(std::ostream& to, const std::string& key, const Declarations& tables) {
  std::vector<std::string> names;
  for (const TableDeclaration& table : tables) {
    for (const KeyDeclaration& declared : table.keys)
      if (declared.name.ends_with("_" + key)) names.push_back(declared.full_name());
  }
  if (!names.empty()) fmt::print(to, "see also {}\n", fmt::join(names, ", "));
}

/// The keys whose name or sentence holds a word, in a line each; false if there are none. Short words stand in too many.
bool explain_mentions(std::ostream& to, const std::string& word, const Declarations& tables) {
  constexpr std::size_t shortest = 4;
  constexpr std::size_t most = 12;
  if (word.size() < shortest) return false;
  std::vector<std::string> lines;
  for (const TableDeclaration& table : tables) {
    for (const KeyDeclaration& key : table.keys) {
      const bool holds =
          key.name.find(lower(word)) != std::string::npos || lower(key.sentence).find(lower(word)) != std::string::npos;
      if (holds) lines.push_back(fmt::format("  {}: {}\n", key.full_name(), key.sentence));
    }
  }
  if (lines.empty() || lines.size() > most) return false;
  fmt::print(to, "there is no key {}; these keys speak of it:\n{}", word, fmt::join(lines, ""));
  return true;
}

}  // namespace

void explain(std::ostream& to, const std::string& key, const Declarations& tables) {
  const FieldWord* entry = find_table(tables, key) != nullptr ? nullptr : find_field_word(key);
  if (entry != nullptr) explain_field_word(to, *entry, tables);
  const bool found = entry != nullptr || explain_named(to, key, tables);
  if (found && entry == nullptr) explain_relatives(to, key, tables);
  for (const TableDeclaration& table : tables) {
    if (table.explain_further != nullptr) table.explain_further(to, key);
  }
  if (found) return;
  std::vector<std::string> known;
  for (const TableDeclaration& table : tables) {
    known.push_back(table.name);
    for (const KeyDeclaration& declared : table.keys) {
      known.push_back(declared.full_name());
      known.push_back(declared.name);
    }
  }
  for (const FieldWord& word : field_words()) known.insert(known.end(), word.words.begin(), word.words.end());
  const auto near = nearest(key, known);
  const bool is_beginning = near && near->starts_with(key);  // "viscous": more keys than the nearest may be meant
  if ((!near || is_beginning) && explain_mentions(to, key, tables)) return;
  throw InputError(fmt::format("explain: there is no key or table {}; {}", key,
                               near ? fmt::format("did you mean {}?", *near) : "`thalweg explain` lists them all"));
}

void write_key_reference(std::ostream& markdown, const Declarations& tables) {
  fmt::print(markdown, R"(# The case file

This page is generated from the declarations in `case/tables/` (target `docs`); `thalweg explain KEY` prints the same
in a terminal, and `case-file.schema.json` beside this page tells it to editors.

A case is a TOML file. Quantities are texts with a unit, read by UDUNITS: `spacing = "2 mm"`, `density = "1540 kg/m^3"`,
`friction_angle = "38 deg"`; only what has no dimension is a plain number. A point has one entry per dimension: `["x", "z"]`
in 2-D, `["x", "y", "z"]` in 3-D. A missing or wrong unit, an unknown key or a value out of range is an error with file
and line.

On the command line `--set table.key=value` overrides a key. A key of a table that may occur several times is named with the
table's name: {}.
)",
             overrides_with_names(tables));
  for (const TableDeclaration& table : tables) write_table_reference(markdown, table);
}

void explain(std::ostream& to, const std::string& key) { explain(to, key, case_declarations()); }

void write_key_reference(std::ostream& markdown) { write_key_reference(markdown, case_declarations()); }

}  // namespace thalweg
