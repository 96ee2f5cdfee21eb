#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace thalweg {

/// Parses a program's arguments into the variables bound to `app`, with those that all programs take: --quiet, --verbose and --json
/// (common/console.hpp) and --version. Returns nothing when the program is to go on, or the exit status when the arguments asked
/// for text alone, such as --help. Throws InputError naming what is wrong with the arguments.
std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv);

}  // namespace thalweg
