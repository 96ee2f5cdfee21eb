#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "common/error.hpp"

namespace thalweg {

/// A required key that is not given. In a table with an unknown key it is left out: that key is the one misspelt.
class MissingKey : public InputError {
 public:
  MissingKey(const std::string& message, std::string table) : InputError(message), table_(std::move(table)) {}
  [[nodiscard]] const std::string& table() const { return table_; }

 private:
  std::string table_;
};

/// Collects the mistakes of a case file, so that one run tells them all.
class Mistakes {
 public:
  /// Calls `part` and keeps the InputError that it throws. False if it threw one.
  bool attempt(const std::function<void()>& part);
  /// Notes that a table has an unknown key.
  void note_unknown_key(const std::string& table) { with_unknown_keys_.insert(table); }
  [[nodiscard]] bool any() const { return !messages_.empty(); }
  /// Throws all of them, each once and in the order of the file, as one InputError; nothing happens without any.
  void throw_any() const;

 private:
  std::vector<std::string> messages_;
  std::set<std::string> with_unknown_keys_;
};

}  // namespace thalweg
