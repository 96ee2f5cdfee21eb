#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// Reads `case_path` (a folder with case.toml, or the file), applies overrides "table.key=value" (as on the command
/// line: --set numerics.spacing="4 mm") and checks everything that can be checked without geometry.
/// Throws InputError "file:line: what is wrong; what to do": unknown table or key (with the nearest known name),
/// missing or wrong unit, value out of range, key of the wrong kind, required key missing, name used twice, shape named
/// but absent.
Case read_case(const std::filesystem::path& case_path, const std::vector<std::string>& overrides = {});

/// Writes every key with its value (defaults included), readable by read_case; this is case.resolved.toml.
/// `resolved.folder` is kept in it, so that reference files are still found. Throws RunError.
void write_case(const std::filesystem::path& file, const Case& resolved);

/// Short hash of all values of a case (not of comments or order) and of the files its shapes name, for provenance.
std::string hash_of(const Case& resolved);
/// The hash proper.
std::string hash_of_text(std::string_view text);

/// Prints unit, default, range and meaning of `key` ("numerics.spacing", "numerics", "spacing") or, if empty, of all.
/// Throws InputError with the nearest known key when there is none.
void explain(std::ostream& to, const std::string& key);

/// The same as a JSON object: {"keys": [{"key", "kind", "unit", "default", "lowest", "highest", "meaning", "words"}]}, and for a word
/// of the field "answer".
std::string explain_json(const std::string& key);
/// The full names of all keys, as --set takes them where a table occurs once: "numerics.spacing".
std::vector<std::string> key_names();

/// The same declarations as docs/case-file.md and as a JSON schema for editors.
void write_key_reference(std::ostream& markdown);
void write_key_schema(std::ostream& json);

}  // namespace thalweg
