#include "solver/program/restart_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/reader/differences.hpp"
#include "common/error.hpp"
#include "common/shown.hpp"
#include "common/version.hpp"

namespace thalweg {
namespace {

/// True for the key itself, and for the keys of a table.
bool covers(const std::string& rule, const std::string& key) { return key == rule || key.starts_with(rule + "."); }

const RestartRule* rule_for(const std::string& key) {
  const auto* found = std::find_if(restart_rules.begin(), restart_rules.end(),
                                   [&](const RestartRule& rule) { return covers(rule.key, key); });
  return found == restart_rules.end() ? nullptr : &*found;
}

void check_words(const std::vector<std::string>& anyway) {
  for (const std::string& word : anyway) {
    const auto is_asked = [&](const RestartRule& rule) { return rule.asked && covers(rule.key, word); };
    if (std::any_of(restart_rules.begin(), restart_rules.end(), is_asked)) continue;
    throw InputError(fmt::format(
        "--restart-anyway {}: no key that may change at a restart; docs/file-formats.md lists them (\"Restart\")",
        word));
  }
}

/// "numerics.cfl 0.5 -> 0.3, …": three at most, short values.
std::string shown(const std::vector<KeyDifference>& differences) {
  constexpr std::size_t most = 3;
  const auto value = [](const std::string& text) {
    return text.empty() ? std::string("absent") : thalweg::shown(text);
  };
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < std::min(most, differences.size()); ++i) {
    parts.push_back(fmt::format("{} {} -> {}", differences[i].key.substr(0, 40), value(differences[i].before),
                                value(differences[i].now)));
  }
  if (differences.size() > most) parts.push_back(fmt::format("{} more", differences.size() - most));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

void check_restart(const std::filesystem::path& file, const Checkpoint& from, const Case& now,
                   const std::vector<std::string>& anyway) {
  check_words(anyway);
  std::vector<KeyDifference> changed = differences(from.case_text, case_text(now));
  const std::string before = release_of(from.particles.info.code_version);
  const std::string own = release_of(version());
  if (before != own) changed.push_back({"version", before, own});
  std::vector<KeyDifference> fixed;
  std::vector<KeyDifference> unasked;
  for (const KeyDifference& difference : changed) {
    const RestartRule* rule = rule_for(difference.key);
    const bool named = std::any_of(anyway.begin(), anyway.end(),
                                   [&](const std::string& word) { return covers(word, difference.key); });
    if (rule == nullptr) fixed.push_back(difference);
    if (rule != nullptr && rule->asked && !named) unasked.push_back(difference);
  }
  if (!fixed.empty()) {
    throw InputError(
        fmt::format("{}: is of another case: {}; set these back, or fill the scene anew and run it from "
                    "its start",
                    file.string(), shown(fixed)));
  }
  if (unasked.empty()) return;
  std::vector<std::string> words;
  for (const KeyDifference& difference : unasked) {
    const std::string word = rule_for(difference.key)->key;
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  if (words.size() > 4) words.assign({"KEY..."});
  throw InputError(
      fmt::format("{}: is of a case with other values: {}; set them back, or go on with --restart-anyway {}",
                  file.string(), shown(unasked), fmt::join(words, " ")));
}

}  // namespace thalweg
