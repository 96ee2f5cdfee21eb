#pragma once

#include <filesystem>
#include <string_view>

namespace thalweg {

/// Looks through the structure of a VTK XML PolyData file before VTK reads it, which trusts what a file announces: sizes
/// against the bytes that are there, numbers of points and cells against the arrays, types, components, offsets, names.
/// Throws InputError "file:line: what is wrong; what to do". Contents are left to who reads them.
void check_poly_data(const std::filesystem::path& file);
/// The same of the text of `file`.
void check_poly_data(const std::filesystem::path& file, std::string_view text);

}  // namespace thalweg
