#include "common/app/verbs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "common/app/programs.hpp"
#include "common/installation.hpp"
#include "common/process.hpp"
#include "common/version.hpp"

namespace thalweg {
namespace {

struct Known {
  const char* name;
  bool built_in;  // answered by `thalweg` itself; the others are programs beside it
  const char* arguments;
  const char* meaning;
};

// In the order of use: from a new scene to a page of results, then what helps on the way.
constexpr std::array known_verbs{
    Known{"new", false, "CASE", "a commented case file to start from"},
    Known{"import", false, "FILE", "a case of another program"},
    Known{"run", true, "CASE", "the whole pipeline, from geometry to report"},
    Known{"gencase", false, "CASE", "shapes to particles; --check only looks whether the case is right"},
    Known{"solver", false, "DIR", "advances the particles in time; --restart latest goes on"},
    Known{"foam", false, "CASE", "the same scene on a mesh, with OpenFOAM"},
    Known{"postproc", false, "DIR", "surfaces, profiles, comparison, report"},
    Known{"info", true, "PATH", "the contents of a case, a particle file or a run's folder"},
    Known{"explain", true, "[KEY]", "unit, default, range and meaning of the keys of a case file"},
    Known{"formulas", true, "CASE", "scour depths by empirical formulas, for a case or for options"},
    Known{"sweep", false, "CASE", "a case over a range of keys: table, pictures, convergence"},
    Known{"validate", false, "[CASE]", "cases measured against nature: a page with numbers and verdicts"},
    Known{"completion", true, "SHELL", "completion of commands for bash, zsh or fish"},
    Known{"help", true, "[COMMAND]", "this overview, or the options of a command"},
};

/// The standard output of a program; empty if it fails. Its errors are of no interest.
std::string output_of(const std::vector<std::string>& command) {
  ChildProcess child(command, {.log = "/dev/null", .piped = STDOUT_FILENO});
  std::string text;
  while (const auto line = child.read_line()) text += *line + "\n";
  return child.wait() == 0 ? text : std::string();
}

std::vector<VerbOption> options_of(const nlohmann::json& described) {
  std::vector<VerbOption> options;
  for (const auto& option : described.at("options"))
    options.push_back({option.at("names"), option.at("place"), option.at("value"), option.at("meaning")});
  return options;
}

}  // namespace

std::vector<Verb> verbs() {
  std::vector<std::string> programs = installed_stages();
  std::vector<Verb> found;
  for (const Known& known : known_verbs) {
    const auto program = std::find(programs.begin(), programs.end(), known.name);
    if (!known.built_in && program == programs.end()) continue;
    if (program != programs.end()) programs.erase(program);
    found.push_back({known.name, known.arguments, known.meaning});
  }
  for (const std::string& program : programs) found.push_back({program, "...", ""});
  return found;
}

std::string overview() {
  std::string text = "usage: thalweg COMMAND [arguments]\n\n";
  for (const Verb& verb : verbs()) text += fmt::format("  {:<20}{}\n", verb.name + " " + verb.arguments, verb.meaning);
  text += fmt::format("\n`thalweg help COMMAND` prints its options. Version {}.\n", version());
  return text;
}

VerbDescription describe(const Verb& verb) {
  const std::vector<std::string> programs = installed_stages();
  const bool is_program = std::find(programs.begin(), programs.end(), verb.name) != programs.end();
  std::vector<std::string> command{(program_folder() / "thalweg").string(), verb.name};
  if (is_program) command = {stage_program(verb.name).string()};
  command.emplace_back("--describe");
  const nlohmann::json described = nlohmann::json::parse(output_of(command), nullptr, false);
  if (!described.is_object() || !described.contains("options")) return {verb, verb.meaning, {}};
  return {verb, described.value("meaning", verb.meaning), options_of(described)};
}

std::vector<VerbDescription> describe_verbs() {
  std::vector<VerbDescription> descriptions;
  for (const Verb& verb : verbs()) descriptions.push_back(describe(verb));
  return descriptions;
}

}  // namespace thalweg
