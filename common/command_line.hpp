#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace thalweg {

/// Parses a program's arguments into the variables bound to `app`. Returns nothing when the program is to go on, or the
/// exit status when --help or --version has been answered. Throws InputError naming what is wrong with the arguments.
std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv);

}  // namespace thalweg
