#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

enum class KeyKind { quantity, number, integer, flag, text, texts, point, quantities, polygon, choice, direction };

/// One declaration of a key, read from the describe() of its table.
struct KeyDeclaration {
  std::string table;  // "numerics", "[shape]", "materials.<sediment>"
  std::string name;
  KeyKind kind = KeyKind::text;
  std::string unit;  // SI; empty for what has none
  double low = 0;    // in the SI unit; numbers, quantities and integers
  double high = 0;
  bool required = false;
  std::string default_text;  // as one would write it in the file; empty when required
  std::string sentence;
  std::vector<std::string> words;           // of a choice
  std::vector<std::string> word_sentences;  // one for each word

  /// "numerics.spacing"; "shape.radius" for a key of [[shape]].
  [[nodiscard]] std::string full_name() const;
  /// Whether a case may have several of its table, under names of their own: [[shape]], [[motion]].
  [[nodiscard]] bool is_list() const { return table.starts_with('['); }
};

struct TableDeclaration {
  std::string name;
  std::string meaning;
  std::vector<KeyDeclaration> keys;
};

/// Every table and key a case file can have, in reading order.
const std::vector<TableDeclaration>& case_declarations();

/// The table "numerics", "[shape]" …; a material other than water is "materials.<sediment>". Null when there is none.
const TableDeclaration* find_table(std::string_view name);

/// The candidate nearest to `word` by edit distance, or nothing when none is near enough to be meant.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace thalweg
