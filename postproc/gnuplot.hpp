#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/error.hpp"

namespace thalweg {

/// A script that does not end.
class ScriptHangs : public RunError {
 public:
  using RunError::RunError;
};

/// Outcome of a script.
enum class GnuplotResult { drawn, not_installed };

/// Runs `gnuplot script` in the script's folder, without a display. The files that it draws (`set output 'NAME'`) appear
/// whole or not at all. The program may be named otherwise by the environment variable THALWEG_GNUPLOT. Throws RunError
/// with gnuplot's own message when the script fails, and ScriptHangs when it has not ended within `patience`.
GnuplotResult run_gnuplot(const std::filesystem::path& script, std::chrono::seconds patience = std::chrono::minutes(2));

/// Draws pictures (run_gnuplot). A script that fails costs its own picture; after one that hangs, or without gnuplot, no
/// other is tried, and a warning says how many are missing, and why. Returns false if a script failed: without gnuplot
/// the report is whole but for its pictures.
bool draw_pictures(const std::vector<std::filesystem::path>& scripts, std::vector<std::string>& warnings);

/// A text as a single-quoted gnuplot string.
std::string gnuplot_string(std::string_view text);

}  // namespace thalweg
