// The umbrella: runs the stages by name, runs them all in order, explains case files and says what is in a run.
#include <CLI/CLI.hpp>
#include <iostream>

#include "case/physics_checks.hpp"
#include "case/reader/case_file.hpp"
#include "common/app/info.hpp"
#include "common/app/pipeline.hpp"
#include "common/app/programs.hpp"
#include "common/app/scour/command.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/process.hpp"

namespace thalweg {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Runs a case from geometry to report: gencase, solver, foam, postproc.", "thalweg run");
  PipelineOptions options;
  std::string backend;
  std::string threads;
  bool no_foam = false;
  app.add_option("CASE", options.case_path, "Folder with case.toml, or the file")->required();
  app.add_option("--out", options.out, "Folder of the run; default: out/<case name>");
  app.add_option("--set", options.overrides, "Overrides a key: numerics.spacing=\"4 mm\"")->allow_extra_args(false);
  app.add_option("--backend", backend, "Passed on to the solver");
  app.add_option("--threads", threads, "Passed on to the solver");
  app.add_flag("--no-foam", no_foam, "Without the mesh model");
  auto* resume = app.add_flag("--resume", options.resume, "Goes on with the run that the folder holds");
  app.add_flag("--force", options.force, "Replaces the run that the folder holds")->excludes(resume);
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (!backend.empty()) options.for_solver.insert(options.for_solver.end(), {"--backend", backend});
  if (!threads.empty()) options.for_solver.insert(options.for_solver.end(), {"--threads", threads});
  options.foam = !no_foam;
  return run_pipeline(options);
}

int explain_keys(int argc, char** argv) {
  CLI::App app("Prints unit, default, range and meaning of the keys of a case file.", "thalweg explain");
  std::string key;
  bool markdown = false;
  bool schema = false;
  bool physics = false;
  app.add_option("KEY", key, "A key or table, such as numerics.spacing, spacing, numerics; default: all");
  auto* as_markdown = app.add_flag("--markdown", markdown, "All keys as the page docs/case-file.md");
  app.add_flag("--schema", schema, "All keys as a JSON schema for editors")->excludes(as_markdown);
  app.add_flag("--physics", physics, "The scenes that are refused as the page docs/refused-physics.md");
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (markdown) {
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
  print_info(std::cout, path);
  return static_cast<int>(Exit::done);
}

void print_usage(std::ostream& to) {
  to << "usage: thalweg COMMAND [arguments]\n\n"
        "  new CASE        a commented case of a scene that runs as it is\n"
        "  run CASE        the whole pipeline, from geometry to report\n"
        "  explain [KEY]   unit, default, range and meaning of the keys of a case file\n"
        "  info PATH       what is in a particle file or a run's folder\n"
        "  formulas CASE   empirical scour formulas for the scene of a case, or for options\n"
        "  validate [CASE] cases measured against nature: one page with numbers and verdicts\n"
        "  sweep CASE      a case over a range of keys: table, pictures, convergence\n"
        "  import FILE     a case from a definition of DualSPHysics (_Def.xml)\n";
  for (const std::string& stage : installed_stages()) {
    if (stage != "validate" && stage != "sweep" && stage != "import" && stage != "new") to << "  " << stage << " ...\n";
  }
  to << "\n`thalweg COMMAND --help` says more. Version " THALWEG_VERSION ".\n";
}

int thalweg_program(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "run") return run(argc - 1, argv + 1);
  if (command == "explain") return explain_keys(argc - 1, argv + 1);
  if (command == "info") return info(argc - 1, argv + 1);
  if (command == "formulas") return formulas_command(argc - 1, argv + 1);
  if (command == "--version") {
    std::cout << "thalweg " THALWEG_VERSION "\n";
    return static_cast<int>(Exit::done);
  }
  if (command == "--help" || command == "-h") {
    print_usage(std::cout);
    return static_cast<int>(Exit::done);
  }
  if (command.empty()) throw InputError("thalweg: no command is given; see thalweg --help");
  std::vector<std::string> stage{stage_program(command).string()};
  stage.insert(stage.end(), argv + 2, argv + argc);
  become(stage);
}

}  // namespace
}  // namespace thalweg

int main(int argc, char** argv) { return thalweg::run_program(thalweg::thalweg_program, argc, argv); }
