#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace thalweg {

/// The beginning of a text from a file, at most 24 characters of it, for a message; '?' for each control character.
inline std::string shown(std::string_view text) {
  constexpr std::size_t most = 24;
  std::string out = text.size() <= most ? std::string(text) : std::string(text.substr(0, most)) + "...";
  const auto controls = [](unsigned char c) { return c < ' ' || c == 127; };
  std::replace_if(out.begin(), out.end(), controls, '?');
  return out;
}

}  // namespace thalweg
