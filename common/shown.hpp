#pragma once

#include <string>
#include <string_view>

namespace thalweg {

/// The beginning of a text from a file, at most 24 characters of it, for a message.
inline std::string shown(std::string_view text) {
  constexpr std::size_t most = 24;
  return text.size() <= most ? std::string(text) : std::string(text.substr(0, most)) + "...";
}

}  // namespace thalweg
