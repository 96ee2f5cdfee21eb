#include "common/command_line.hpp"

#include <CLI/CLI.hpp>

#include "common/error.hpp"

namespace thalweg {

std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv) {
  app.set_version_flag("--version", "thalweg " THALWEG_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& answered) {
    return app.exit(answered);
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string("command line: ") + error.what() + "; see " + app.get_name() + " --help");
  }
  return std::nullopt;
}

}  // namespace thalweg
