#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg::html {

/// A text with &, <, > and quotes as entities.
std::string escape(std::string_view text);

/// A value with its unit as HTML: minus signs and exponents as a typesetter sets them ("-9.81 m/s^2").
std::string typeset(std::string_view value);

/// A table; cells are HTML already. Columns whose letter in `alignment` is 'r' are numbers, 'l' texts. A row of one
/// cell is a heading across all columns.
std::string table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows,
                  const std::string& alignment, const std::string& css_class = "");

/// An SVG file as an element of a page: without its prologue, its ids made unique by `prefix`, named by `title`.
/// Empty when the file cannot be read.
std::string inline_svg(const std::filesystem::path& file, const std::string& prefix, const std::string& title);

/// A PNG file as an <img> with the data in it. Empty when the file cannot be read.
std::string inline_png(const std::filesystem::path& file, const std::string& title);

/// Bytes as base64.
std::string base64(std::string_view bytes);

/// 12345678 → "12 345 678" with thin spaces that do not break.
std::string grouped(double number);

}  // namespace thalweg::html
