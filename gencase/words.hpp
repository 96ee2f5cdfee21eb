#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// What the checks of mesh files in text look at.
namespace thalweg::gencase {

inline std::vector<std::string> words_of(const std::string& line) {
  std::istringstream text(line);
  return {std::istream_iterator<std::string>(text), {}};
}

/// Digits alone, and no more of them than a count of anything in a file has.
inline bool is_count(const std::string& word) {
  constexpr std::size_t most_digits = 10;
  return word.size() <= most_digits && word.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace thalweg::gencase
