#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "case/reader/case_file.hpp"
#include "common/command_line.hpp"
#include "common/console.hpp"
#include "common/error.hpp"
#include "common/io/ranged_particle_file.hpp"
#include "common/io/run_results.hpp"
#include "common/particle_words.hpp"
#include "common/run_folder.hpp"
#include "common/run_lock.hpp"
#include "common/warnings.hpp"
#include "common/whole_file.hpp"
#include "gencase/generate.hpp"
#include "gencase/report.hpp"

namespace {

using thalweg::Case;
namespace fs = std::filesystem;

thalweg::gencase::GenerateOptions options_for(const fs::path& folder, bool check) {
  thalweg::gencase::GenerateOptions options;
  options.notes.say = [](const std::string& line) { thalweg::say(line); };
  options.notes.warn = [folder, check](const std::string& line) {
    thalweg::warn(line);
    if (!check) thalweg::WarningFile({folder}, "gencase").add(line);
  };
  if (!check)
    options.notes.draw = [folder](const std::string& name, const thalweg::LineSet& lines) {
      const fs::path file = folder / (name + ".vtp");
      thalweg::write_lines(file, lines);
      return file.string();
    };
  options.progress = true;
  return options;
}

/// The scene as --json tells it: how many particles of which kind.
std::string result_of(const Case& scene, const thalweg::gencase::Generated& generated, const std::string& folder) {
  nlohmann::ordered_json result{{"case", scene.info.name}, {"dimension", scene.info.dimension}};
  result["spacing"] = scene.numerics.spacing;
  if (!folder.empty()) result["folder"] = folder;
  const auto& counts = generated.summary.counts;
  for (std::size_t type = 0; type < counts.size(); ++type)
    result["particles"][thalweg::type_words[type]] = counts[type];
  return result.dump(2);
}

void ask_for_repair(Case& scene) {
  for (thalweg::Shape& shape : scene.shapes)
    shape.repair = shape.repair || shape.uses_key("repair", scene.info.dimension);
}

int gencase(int argc, char** argv) {
  CLI::App app{"Fills the geometry of a case with particles at hydrostatic rest.", "thalweg-gencase"};
  std::string case_path;
  std::string out;
  std::vector<std::string> overrides;
  bool check = false;
  bool repair = false;
  bool force = false;
  bool larger_than_memory = false;
  app.add_option("CASE", case_path, "folder with case.toml, or the file")->required();
  app.add_option("--out", out, "folder of the run; default: out/<case name>");
  app.add_option("--set", overrides, "key=value: overrides a key of the case, as in numerics.spacing=\"4 mm\"")
      ->expected(1)
      ->take_all();
  app.add_flag("--check", check, "do everything but write files");
  app.add_flag("--repair", repair, "mend surface meshes that bound no volume, and say what was changed");
  app.add_flag("--force", force, "fill the folder although it holds a run, whose results then belong to another scene");
  app.add_flag(
      "--larger-than-memory", larger_than_memory,
      "fill a scene that needs more memory to run than this machine has: several machines compute it (--ranks)");
  if (const auto answered = thalweg::parse_command_line(app, argc, argv)) return *answered;

  Case scene = thalweg::read_case(case_path, overrides);
  if (repair) ask_for_repair(scene);
  const thalweg::RunFolder folder{out.empty() ? fs::path("out") / scene.info.name : fs::path(out)};
  std::optional<thalweg::RunLock> lock;
  if (!check) {
    lock.emplace(folder.root, "thalweg-gencase");
    if (!force) thalweg::refuse_to_replace(folder, "fill another folder (--out), or replace it with --force");
    thalweg::remove_dead_parts(folder.root);
    thalweg::forget_warnings(folder);
    thalweg::forget_log(folder);
    thalweg::keep_log(folder, "gencase");
  }
  const auto begin = std::chrono::steady_clock::now();
  auto options = options_for(folder.root, check);
  options.larger_than_memory = larger_than_memory;
  std::optional<thalweg::RangedParticleFile> file;
  if (!check) file.emplace(folder.particles());
  const thalweg::gencase::Generated generated =
      thalweg::gencase::generate_in_ranges(scene, options, [&](const thalweg::ParticleSet& range) {
        if (file) file->add(range);
      });
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  thalweg::say(fmt::format("{}{} lattice points in {:.2f} s", thalweg::gencase::report(generated),
                           generated.summary.lattice_nodes, seconds));
  thalweg::set_result(result_of(scene, generated, check ? "" : folder.root.string()));
  if (check) {
    thalweg::say("checked only: nothing written");
    return static_cast<int>(thalweg::Exit::done);
  }
  if (file->size() == 0) throw thalweg::RunError(folder.particles().string() + ": cannot be written: no particles");
  file->finish({generated.particles.info});
  thalweg::write_case(folder.resolved_case(), generated.resolved);
  thalweg::say(fmt::format("written: {} and {}", folder.particles().string(), folder.resolved_case().string()));
  return static_cast<int>(thalweg::Exit::done);
}

}  // namespace

int main(int argc, char** argv) { return thalweg::run_program(gencase, argc, argv); }
