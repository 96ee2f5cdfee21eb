#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// Words and numbers of mesh files in text, for the checks before they are read.
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

}  // namespace thalweg::gencase
