#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "common/app/scour/rows.hpp"

namespace thalweg {

/// The value of a row with its unit; "?" where an input is not known, "none" where the formula gives nothing.
std::string value_text(const FormulaRow& row);

/// A limit of a formula's range that the scene leaves: "depth/width 0.4 < 1".
std::string limit_text(const LimitLeft& left);

/// Prints rows for people: by subject, each formula with its value, the limits that are left, its inputs and its
/// source.
void print_rows(std::ostream& to, const std::vector<FormulaRow>& rows, const std::vector<std::string>& notes);

/// The same table as CSV, one line a formula, whole or not at all. Throws RunError.
void write_rows_csv(const std::filesystem::path& file, const std::vector<FormulaRow>& rows);

/// The same as a JSON document: {"rows": [...], "notes": [...]}; a value that is not known is null.
void print_rows_json(std::ostream& to, const std::vector<FormulaRow>& rows, const std::vector<std::string>& notes);

}  // namespace thalweg
