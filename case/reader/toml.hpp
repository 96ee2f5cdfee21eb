#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

#include "case/reader/declarations.hpp"

namespace thalweg {

/// Throws InputError "where: what; cure".
[[noreturn]] void reject_case(const std::string& where, const std::string& what, const std::string& cure);

/// "case.toml:12", or the whole text of the override that gave the value; the first line of `file` for a table that
/// no line begins.
std::string where_is(const toml::node& node, const std::string& file);

/// Reads TOML. Throws InputError with file and line.
toml::table parse_case_toml(const std::filesystem::path& file);

/// Puts the value of "table.key=value" into `root`; its nodes remember that they come from an override. Throws
/// InputError when the text is no override, or names an entry of a repeated table or a table by name that is absent.
void apply_override(toml::table& root, const std::string& text, const Declarations& tables);

/// The name of one of several tables, such as [[gauge]]; empty when it has none or no text.
std::string name_of_entry(const toml::table& entry);

/// The table of a case.resolved.toml that says what it was resolved from; no table of a case.
inline constexpr const char* resolved_table = "resolved";

}  // namespace thalweg
