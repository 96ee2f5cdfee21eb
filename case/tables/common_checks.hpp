#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "case/check_context.hpp"
#include "case/tables/table.hpp"
#include "common/particles.hpp"

// Checks that several tables share. Each throws InputError through CheckContext::reject.
namespace thalweg {

/// The key `name` has to be fit for names of files and folders.
void check_file_name(const CheckContext& at, const std::string& name);

/// A name that stands in messages, files and dictionaries of other programs has to be a word of letters, digits, blanks
/// and a few signs, at most 64 bytes long. `kind` says what it names: "shape".
void check_word(const CheckContext& at, const std::string& kind, const std::string& name);

/// A text of one line must not hold control characters.
void check_line_of_text(const CheckContext& at, std::string_view key, const std::string& text);

/// `from` and `to` have to be the lower and the upper corner of a box.
void check_corners(const CheckContext& at, const Vec3& from, const Vec3& to);

/// The times of the key have to lie within a run that ends at `end` [s].
void check_within_run(const CheckContext& at, std::string_view key, const std::vector<double>& times, double end);

/// A table of the entry, `times` [s] and the values of the key `column`, has to have as many of both, two at least, and
/// times that increase.
void check_table_over_time(const CheckContext& at, const std::string& column, const std::vector<double>& times,
                           const std::vector<double>& values);

/// Refuses keys that are given and mean nothing in this entry (uses_key). `reason_of(key)` ends the message "KEY means
/// nothing ...": "with drive = \"off\"".
template <class Entry, class Reason>
void check_unused_keys(const CheckContext& at, const Entry& entry, const Reason& reason_of,
                       const std::string& cure = "remove it") {
  for (const std::string& key : at.keys()) {
    if (!at.given(key) || entry.uses_key(key, at.dimension())) continue;
    at.reject(at.key(key), fmt::format("{} means nothing {}", at.key(key), reason_of(key)), cure);
  }
}

/// An entry's kind decides which keys it needs and which mean nothing. `also` is said of what decides beside the kind.
template <class Entry>
void check_keys(const CheckContext& at, const Entry& entry, std::string_view also = "") {
  const std::string kind = fmt::format("a {} of kind \"{}\"", Entry::heading.name, word_for(entry.kind));
  const std::vector<std::string> needed = entry.needs_keys(at.dimension());
  for (const std::string& key : needed) {
    if (at.given(key)) continue;
    at.reject(at.path(), fmt::format("{} is missing", at.key(key)),
              fmt::format("{} needs {}", kind, fmt::join(needed, ", ")));
  }
  check_unused_keys(at, entry, [&](const std::string&) { return fmt::format("for {}{}", kind, also); });
}

}  // namespace thalweg
