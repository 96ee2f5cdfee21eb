#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "case/reader/case_file.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/run_folder.hpp"
#include "foam_reference/all_models.hpp"
#include "foam_reference/foam_run.hpp"

namespace thalweg {
namespace {

int run(int argc, char** argv) {
  std::string case_path;
  std::string out;
  std::string cell;
  std::vector<std::string> settings;
  foam::ModelOptions options;

  CLI::App app("Computes a scene on a mesh with OpenFOAM, to be seen beside the particle model.", "thalweg-foam");
  app.add_option("case", case_path, "Folder with case.toml, or the file")->required();
  app.add_option("--out", out, "Folder of the run; results go to DIR/foam/MODEL (default: out/NAME)");
  app.add_option("--cell", cell, "Cell size with unit, such as \"10 mm\" (default: foam.cell of the case)");
  app.add_option("--model", options.model,
                 "One model only: same-material, eroding-bed or stock (default: foam.models of the case)");
  app.add_option("--meshes", options.meshes, "Number of meshes, each twice as coarse as the one before")
      ->check(CLI::Range(1, 4));
  app.add_flag("--check", options.check, "Only say whether there is a mesh model of the scene, and OpenFOAM");
  app.add_option("--ranks", options.ranks, "Number of processes")->check(CLI::Range(1, 4096));
  app.add_option("--set", settings, "Sets a key of the case file: numerics.spacing=\"4 mm\"")->allow_extra_args(false);
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;

  if (!cell.empty()) settings.push_back("foam.cell=\"" + cell + "\"");
  const Case scene = read_case(case_path, settings);
  const RunFolder folder{out.empty() ? std::filesystem::path("out") / scene.info.name : std::filesystem::path(out)};
  try {
    foam::run_models(scene, folder, options);
  } catch (const foam::Interrupted& interrupted) {
    fmt::print(stderr, "foam: interrupted; {} is not finished\n", folder.foam().string());
    return static_cast<int>(interrupted.signal == SIGINT ? Exit::interrupted : Exit::terminated);
  }
  return static_cast<int>(Exit::done);
}

}  // namespace
}  // namespace thalweg

int main(int argc, char** argv) { return thalweg::run_program(thalweg::run, argc, argv); }
