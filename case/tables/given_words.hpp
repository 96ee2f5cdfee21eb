#pragma once

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <system_error>

#include "case/tables/table.hpp"

namespace thalweg {

/// The texts and numbers of a case file, for tables whose defaults follow from one of them (set_defaults).
struct GivenWords {
  struct Word {
    std::string text;
    std::string where;  // "case.toml:12" or "--set …"
  };

  std::filesystem::path folder;       // of the case
  bool resolved = false;              // the file is a case.resolved.toml
  std::map<std::string, Word> words;  // "model.implementation" …; "inlet" if there is one

  /// True if a current lasts: driven around a period, or fed by an inlet (Case::has_lasting_current).
  [[nodiscard]] bool has_lasting_current() const {
    return text("flow.drive", "off") != "off" || words.contains("inlet");
  }

  /// The place of the key's text; empty if it is not given.
  [[nodiscard]] std::string where(const std::string& key) const {
    const auto found = words.find(key);
    return found != words.end() ? found->second.where : std::string();
  }

  /// The text of the key, or `otherwise` if it is not given.
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise) const {
    const auto found = words.find(key);
    return found != words.end() ? found->second.text : otherwise;
  }

  /// The key's number; nothing if it is not given, or is no number, which the reader refuses later.
  [[nodiscard]] std::optional<double> number(const std::string& key) const {
    const std::string digits = text(key, "");
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return value;
  }

  /// The enumerator that the key names; nothing if it is not given, or unknown, which the reader refuses later.
  template <class E>
  [[nodiscard]] std::optional<E> choice(const std::string& key) const {
    const auto found = words.find(key);
    if (found == words.end()) return std::nullopt;
    for (const Choice<E>& candidate : choices(E{})) {
      if (found->second.text == candidate.name) return candidate.value;
    }
    return std::nullopt;
  }
};

}  // namespace thalweg
