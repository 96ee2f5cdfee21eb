#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace thalweg {

/// Outcome of a script.
enum class GnuplotResult { drawn, not_installed };

/// Runs `gnuplot script` in the script's folder, without a display. The files that it draws (`set output 'NAME'`) appear
/// whole or not at all. The program may be named otherwise by the environment variable THALWEG_GNUPLOT. Throws RunError
/// with gnuplot's own message when the script fails, and when it has not ended within `patience`.
GnuplotResult run_gnuplot(const std::filesystem::path& script, std::chrono::seconds patience = std::chrono::minutes(2));

/// A text as a single-quoted gnuplot string.
std::string gnuplot_string(std::string_view text);

}  // namespace thalweg
