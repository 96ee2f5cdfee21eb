#include "common/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "common/console.hpp"
#include "common/error.hpp"
#include "common/version.hpp"

namespace thalweg {
namespace {

// Answered by every program, the ones in Python too (validation/faults.py); completion and man pages are made of it.
constexpr std::string_view describe_option = "--describe";

void describe(const CLI::App& app) {
  nlohmann::ordered_json described{{"name", app.get_name()}, {"meaning", app.get_description()}};
  described["options"] = nlohmann::ordered_json::array();
  for (const CLI::Option* option : app.get_options()) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const bool takes_value = option->get_items_expected_max() > 0;
    described["options"].push_back({{"names", names},
                                    {"place", names.empty() ? option->get_name() : ""},
                                    {"value", takes_value ? option->get_type_name() : ""},
                                    {"meaning", option->get_description()}});
  }
  fmt::print("{}\n", described.dump(1));
}

}  // namespace

std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv) {
  bool version_asked = false;
  bool json = false;
  app.add_flag("--version", version_asked, "Prints version, commit and what is installed");
  auto* quiet = app.add_flag_function(
      "--quiet", [](auto) { set_verbosity(Verbosity::quiet); }, "Shows warnings and errors alone");
  app.add_flag_function(
         "--verbose", [](auto) { set_verbosity(Verbosity::verbose); }, "Shows more of what happens")
      ->excludes(quiet);
  if (app.get_option_no_throw("--json") == nullptr)
    app.add_flag("--json", json, "Prints one JSON object on stdout: the result, or the errors");
  if (argc == 2 && argv[1] == describe_option) {
    describe(app);
    return static_cast<int>(Exit::done);
  }
  // Read before the parser runs: its own errors are answered in JSON too.
  if (std::find(argv, argv + argc, std::string_view("--json")) != argv + argc) answer_in_json();
  // Answered before a missing CASE is an error.
  if (std::find(argv, argv + argc, std::string_view("--version")) != argv + argc) {
    fmt::print("{}", version_text(app.get_name().substr(0, app.get_name().find(' '))));
    return static_cast<int>(Exit::done);
  }
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
