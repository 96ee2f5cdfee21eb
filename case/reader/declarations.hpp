#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table_list.hpp"

namespace thalweg {

enum class KeyKind { quantity, number, integer, flag, text, texts, point, quantities, polygon, choice, direction };

/// One declaration of a key, read from the describe() of its table.
struct KeyDeclaration {
  std::string table;  // "numerics", "shape", "materials.<sediment>"
  std::string name;
  KeyKind kind = KeyKind::text;
  std::string unit;  // SI; empty for a key without one
  double low = 0;    // in the SI unit; numbers, quantities and integers
  double high = 0;
  bool required = false;
  std::string default_text;  // as one would write it in the file; empty when required
  std::string sentence;
  std::vector<std::string> words;           // of a choice
  std::vector<std::string> word_sentences;  // one for each word

  /// "numerics.spacing"; "shape.radius" for a key of [[shape]].
  [[nodiscard]] std::string full_name() const { return table + "." + name; }
};

struct TableDeclaration {
  std::string name;  // "numerics", "shape", "materials.<sediment>"
  TableForm form = TableForm::single;
  std::string meaning;
  std::string note;            // a paragraph for the reference, or empty
  bool indispensable = false;  // a case without it is refused
  std::vector<KeyDeclaration> keys;
  /// Prints what `thalweg explain` adds when it is asked for a key or a table; null if there is nothing to add.
  void (*explain_further)(std::ostream& to, std::string_view key) = nullptr;

  [[nodiscard]] std::vector<std::string> key_names() const;
  /// As it stands in a case file: "[numerics]", "[[shape]]".
  [[nodiscard]] std::string title() const;
};

/// All tables of a kind of case, in reading order.
using Declarations = std::vector<TableDeclaration>;

/// Every table and key of a case file (struct Case).
const Declarations& case_declarations();

/// The table of a name or path: "numerics", "shape", "materials.<sediment>", "materials.pvc" (a table by name, unless a
/// single table has that name). Null when there is none.
const TableDeclaration* find_table(const Declarations& tables, std::string_view name);

/// The groups of the tables by name: "materials".
std::vector<std::string> groups_of(const Declarations& tables);

}  // namespace thalweg
