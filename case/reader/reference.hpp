#pragma once

#include <iosfwd>
#include <string>

#include "case/reader/declarations.hpp"

// The declarations for the user: in the terminal, as a page, and as a schema for editors. case_file.hpp has the same
// functions for the tables of Case.
namespace thalweg {

/// Throws InputError with the nearest known key when there is none.
void explain(std::ostream& to, const std::string& key, const Declarations& tables);
void write_key_reference(std::ostream& markdown, const Declarations& tables);
void write_key_schema(std::ostream& json, const Declarations& tables);

/// True if the key's value has a lowest and a highest value.
bool has_range(const KeyDeclaration& key);
/// "1 um to 100 m"; empty if the key has no range.
std::string range_text(const KeyDeclaration& key);
/// The default, or in which case a key is required.
std::string default_text(const KeyDeclaration& key, TableForm form);

}  // namespace thalweg
