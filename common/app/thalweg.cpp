// The umbrella: runs the stages by name, runs them all in order, explains case files and says what is in a run.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "case/physics_checks.hpp"
#include "case/reader/case_file.hpp"
#include "common/app/completion.hpp"
#include "common/app/info.hpp"
#include "common/app/pipeline.hpp"
#include "common/app/programs.hpp"
#include "common/app/scour/command.hpp"
#include "common/app/verbs.hpp"
#include "common/command_line.hpp"
#include "common/console.hpp"
#include "common/error.hpp"
#include "common/process.hpp"
#include "common/version.hpp"

namespace thalweg {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Runs a case from geometry to report: gencase, solver, foam, postproc.", "thalweg run");
  PipelineOptions options;
  std::string backend;
  std::string threads;
  std::string ranks;
  std::string device_messages;
  bool no_foam = false;
  app.add_option("CASE", options.case_path, "Folder with case.toml, or the file")->required();
  app.add_option("--out", options.out, "Folder of the run; default: out/<case name>");
  app.add_option("--set", options.overrides, "Overrides a key: numerics.spacing=\"4 mm\"")->allow_extra_args(false);
  app.add_option("--backend", backend, "Device of the solver: a GPU if there is one, that, or CPU cores")
      ->type_name("auto|cuda|openmp");
  app.add_option("--threads", threads, "CPU threads of the solver; default: all cores");
  app.add_option("--ranks", ranks, "Processes of the solver, each with its share of the particles (docs/ranks.md)");
  app.add_option("--device-messages", device_messages, "Messages between the GPUs of ranks (docs/ranks.md)")
      ->type_name("auto|host|mpi|nccl");
  app.add_flag("--no-foam", no_foam, "Without the mesh model");
  auto* resume = app.add_flag("--resume", options.resume, "Goes on with the run that the folder holds");
  app.add_flag("--force", options.force, "Replaces the run that the folder holds")->excludes(resume);
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (!backend.empty()) options.for_solver.insert(options.for_solver.end(), {"--backend", backend});
  if (!threads.empty()) options.for_solver.insert(options.for_solver.end(), {"--threads", threads});
  if (!ranks.empty()) options.for_solver.insert(options.for_solver.end(), {"--ranks", ranks});
  if (!device_messages.empty()) {
    options.for_solver.insert(options.for_solver.end(), {"--device-messages", device_messages});
  }
  options.foam = !no_foam;
  return run_pipeline(options);
}

int explain_keys(int argc, char** argv) {
  CLI::App app("Prints unit, default, range and meaning of the keys of a case file.", "thalweg explain");
  std::vector<std::string> words;
  bool markdown = false;
  bool schema = false;
  bool physics = false;
  app.add_option("KEY", words,
                 "A key, a table or words of the field: numerics.spacing, scour depth, inflow; default: all");
  auto* as_markdown = app.add_flag("--markdown", markdown, "All keys as the page docs/case-file.md");
  app.add_flag("--schema", schema, "All keys as a JSON schema for editors")->excludes(as_markdown);
  app.add_flag("--physics", physics, "The scenes that are refused as the page docs/refused-physics.md");
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  const std::string key = fmt::format("{}", fmt::join(words, " "));
  if (answers_in_json()) {
    set_result(explain_json(key));
  } else if (markdown) {
    write_key_reference(std::cout);
  } else if (schema) {
    write_key_schema(std::cout);
  } else if (physics) {
    write_physics_checks(std::cout);
  } else {
    explain(std::cout, key);
  }
  return static_cast<int>(Exit::done);
}

int info(int argc, char** argv) {
  CLI::App app("Says what is in a particle file, a series or a run's folder.", "thalweg info");
  std::string path;
  app.add_option("PATH", path, "particles.vtp, a snapshot, snapshots.pvd, or a run's folder")->required();
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (answers_in_json()) {
    set_result(info_json(path));
  } else {
    print_info(std::cout, path);
  }
  return static_cast<int>(Exit::done);
}

int completion(int argc, char** argv) {
  CLI::App app("Prints a script that completes commands, options and keys of the case file.", "thalweg completion");
  std::string shell;
  app.add_option("SHELL", shell, "bash, zsh or fish; load it with: source <(thalweg completion bash)")
      ->required()
      ->type_name("bash|zsh|fish");
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  const auto make = shell == "bash"   ? bash_completion
                    : shell == "zsh"  ? zsh_completion
                    : shell == "fish" ? fish_completion
                                      : nullptr;
  if (make == nullptr)
    throw InputError("thalweg completion: \"" + shell.substr(0, 40) +
                     "\" is no shell it knows; write bash, zsh or fish");
  std::cout << make(describe_verbs(), key_names());
  return static_cast<int>(Exit::done);
}

void print_manual(const std::string& command) {
  if (command.empty()) std::cout << overview_manual(verbs());
  for (const Verb& verb : verbs())
    if (verb.name == command) std::cout << verb_manual(describe(verb));
}

/// Throws InputError, with the nearest command, if there is none of this name.
void require_command(const std::string& command) {
  const std::vector<Verb> known = verbs();
  if (std::none_of(known.begin(), known.end(), [&](const Verb& verb) { return verb.name == command; }))
    (void)stage_program(command);
}

int thalweg_program(int argc, char** argv);

int help(int argc, char** argv) {
  CLI::App app("Prints the commands in the order of use, or the options of one.", "thalweg help");
  std::string command;
  bool manual = false;
  app.add_option("COMMAND", command, "A command, such as run");
  app.add_flag("--man", manual, "As a page of the manual: thalweg help run --man | man -l -");
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (!command.empty()) require_command(command);
  if (manual) {
    print_manual(command);
  } else if (command.empty()) {
    std::cout << overview();
  } else {
    std::array<std::string, 3> words{"thalweg", command, "--help"};
    std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    return thalweg_program(3, arguments.data());
  }
  return static_cast<int>(Exit::done);
}

struct BuiltIn {
  const char* name;
  int (*body)(int, char**);
};
constexpr std::array built_in{BuiltIn{"run", run},   BuiltIn{"explain", explain_keys},
                              BuiltIn{"info", info}, BuiltIn{"formulas", formulas_command},
                              BuiltIn{"help", help}, BuiltIn{"completion", completion}};

int thalweg_program(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  for (const BuiltIn& known : built_in)
    if (command == known.name) return known.body(argc - 1, argv + 1);
  if (command == "--version") {
    std::cout << version_text("thalweg");
    return static_cast<int>(Exit::done);
  }
  if (command == "--help" || command == "-h") {
    std::cout << overview();
    return static_cast<int>(Exit::done);
  }
  if (command.empty()) throw InputError("thalweg: no command is given; see thalweg help");
  std::vector<std::string> stage{stage_program(command).string()};
  stage.insert(stage.end(), argv + 2, argv + argc);
  become(stage);
}

}  // namespace
}  // namespace thalweg

int main(int argc, char** argv) { return thalweg::run_program(thalweg::thalweg_program, argc, argv); }
