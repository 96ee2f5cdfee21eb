#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// The answer of a case file to a word of the field that is no key: "inflow", "scour depth", "slope".
struct FieldWord {
  std::vector<std::string> words;  // lower case
  std::string answer;              // a sentence or two
  std::vector<std::string> keys;   // tables and keys to look at
};

/// All words that `thalweg explain` knows beside the keys.
const std::vector<FieldWord>& field_words();

/// The entry of a word, in any case, in singular or plural, with blanks, hyphens or underscores. Null if there is none.
const FieldWord* find_field_word(std::string_view word);

}  // namespace thalweg
