#pragma once

#include <charconv>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "common/shown.hpp"

// Words and numbers of mesh files in text.
namespace thalweg::gencase {

/// The words of a line, separated by blanks.
inline std::vector<std::string> words_of(const std::string& line) {
  std::istringstream text(line);
  return {std::istream_iterator<std::string>(text), {}};
}

/// True if the word is a number of elements: digits alone, and at most ten of them.
inline bool is_count(const std::string& word) {
  constexpr std::size_t most_digits = 10;
  return word.size() <= most_digits && word.find_first_not_of("0123456789") == std::string::npos;
}

/// The number that is the whole word; nothing for anything else.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace thalweg::gencase
