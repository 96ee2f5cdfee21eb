#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace thalweg {

/// Throws InputError "where: what; cure".
[[noreturn]] void reject_case(const std::string& where, const std::string& what, const std::string& cure);

/// "case.toml:12", or the whole text of the override that gave the value; the first line of `file` for a table that
/// no line begins.
std::string where_is(const toml::node& node, const std::string& file);

/// Reads TOML. Throws InputError with file and line.
toml::table parse_case_toml(const std::filesystem::path& file);

/// Puts the value of "table.key=value" into `root`; its nodes remember that they come from an override. Throws
/// InputError when the text is no override or names an absent entry of a list or material.
void apply_override(toml::table& root, const std::string& text);

/// The name of a [[shape]], [[gauge]] …; empty when it has none or no text.
std::string name_of_entry(const toml::table& entry);

/// The lists of tables with names: "shape", "motion", "gauge", "line".
bool is_list_of_tables(std::string_view name);

}  // namespace thalweg
