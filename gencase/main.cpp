#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "common/case_file.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/run_folder.hpp"
#include "gencase/generate.hpp"
#include "gencase/report.hpp"

namespace {

int gencase(int argc, char** argv) {
  CLI::App app{"Fills the geometry of a case with particles at hydrostatic rest.", "thalweg-gencase"};
  std::string case_path;
  std::string out;
  std::vector<std::string> overrides;
  bool check = false;
  app.add_option("CASE", case_path, "folder with case.toml, or the file")->required();
  app.add_option("--out", out, "folder of the run; default: out/<case name>");
  app.add_option("--set", overrides, "key=value: overrides a key of the case, as in numerics.spacing=\"4 mm\"")
      ->expected(1)
      ->take_all();
  app.add_flag("--check", check, "do everything but write files");
  if (const auto answered = thalweg::parse_command_line(app, argc, argv)) return *answered;

  const thalweg::Case scene = thalweg::read_case(case_path, overrides);
  const auto begin = std::chrono::steady_clock::now();
  thalweg::gencase::GenerateOptions options;
  options.say = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);  // the count is to be seen before the memory is taken
  };
  options.warn = [](const std::string& line) { fmt::print(stderr, "warning: {}\n", line); };
  const thalweg::gencase::Generated generated = thalweg::gencase::generate(scene, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print("{}{} lattice points in {:.2f} s\n", thalweg::gencase::report(generated), generated.summary.lattice_nodes,
             seconds);
  if (check) {
    fmt::print("checked only: nothing written\n");
    return static_cast<int>(thalweg::Exit::done);
  }

  const thalweg::RunFolder folder{out.empty() ? std::filesystem::path("out") / scene.info.name
                                              : std::filesystem::path(out)};
  thalweg::write_particles(folder.particles(), generated.particles, thalweg::PositionPrecision::double_precision);
  thalweg::write_case(folder.resolved_case(), generated.resolved);
  fmt::print("written: {} and {}\n", folder.particles().string(), folder.resolved_case().string());
  return static_cast<int>(thalweg::Exit::done);
}

}  // namespace

int main(int argc, char** argv) { return thalweg::run_program(gencase, argc, argv); }
