#include "common/app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "case/reader/case_file.hpp"
#include "case/reader/differences.hpp"
#include "common/app/programs.hpp"
#include "common/error.hpp"
#include "common/io/run_results.hpp"
#include "common/process.hpp"
#include "common/run_folder.hpp"

namespace thalweg {
namespace {

struct Stage {
  std::string name;
  std::vector<std::string> arguments;
  bool needed = true;  // the pipeline ends if it fails; otherwise the report does without it
};

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// True if the folder holds the run of this case from its start to its end.
bool is_finished(const RunFolder& run, double end) {
  constexpr double rounding = 1e-9;
  return std::filesystem::exists(run.summary()) && time_reached(run).value_or(0) >= end * (1 - rounding);
}

/// The stages that fill and run the scene in a folder: all of them, or with --resume those that are not done.
void add_run(std::vector<Stage>& stages, const PipelineOptions& options, const RunFolder& run, const Words& overrides,
             double end, bool needed) {
  const Words force = options.force ? Words{"--force"} : Words{};
  const std::string folder = run.root.string();
  const bool filled = std::filesystem::exists(run.resolved_case()) && std::filesystem::exists(run.particles());
  if (!options.resume || !filled) {
    const Words arguments{options.case_path.string(), "--out", folder};
    stages.push_back({"gencase", with(with(arguments, overrides), force), needed});
  }
  if (options.resume && is_finished(run, end)) return;
  const Words start = options.resume ? Words{"--restart", "latest"} : force;
  stages.push_back({"solver", with(with({folder}, options.for_solver), start), needed});
}

std::vector<Stage> stages_of(const PipelineOptions& options, const Case& scene, const std::string& out) {
  Words overrides;
  for (const std::string& text : options.overrides) overrides.insert(overrides.end(), {"--set", text});
  std::vector<Stage> stages;
  add_run(stages, options, RunFolder{out}, overrides, scene.output.end, true);
  for (int run = 1, times = 2; run < scene.compare.runs; ++run, times *= 2) {
    const RunFolder folder = RunFolder{out}.coarser(times);
    const std::string spacing = fmt::format("numerics.spacing={} m", times * scene.numerics.spacing);
    add_run(stages, options, folder, with(overrides, {"--set", spacing}), scene.output.end, false);
    stages.push_back({"postproc", {folder.root.string()}, false});
  }
  if (options.foam) {
    stages.push_back({"foam", with({options.case_path.string(), "--out", out}, overrides), false});
  }
  stages.push_back({"postproc", {out, "--report"}});
  return stages;
}

/// A folder that was filled from another case cannot be gone on with. The largest speed is gencase's to find.
void require_same_case(const RunFolder& run, const Case& scene) {
  if (!std::filesystem::exists(run.resolved_case())) return;
  for (const KeyDifference& key : differences(case_text(read_case(run.resolved_case())), case_text(scene))) {
    if (key.key == "numerics.maximum_speed" && scene.numerics.maximum_speed == 0) continue;
    throw InputError(
        fmt::format("{}: filled from another case: {} {} -> {}; give the same case and --set to --resume "
                    "it, or another --out",
                    run.root.string(), key.key, key.before, key.now));
  }
}

void announce(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);  // before the stage's own lines
}

}  // namespace

int run_pipeline(const PipelineOptions& given) {
  PipelineOptions options = given;
  const Case scene = read_case(options.case_path, options.overrides);
  const std::string out = (options.out.empty() ? std::filesystem::path("out") / scene.info.name : options.out).string();
  if (options.foam && !on_path("blockMesh")) {
    announce("foam: skipped, because OpenFOAM is not installed; get it with: apt-get install openfoam");
    options.foam = false;
  }

  const bool moves = std::any_of(scene.shapes.begin(), scene.shapes.end(),
                                 [](const Shape& shape) { return shape.role == ShapeRole::moving_wall; });
  if (options.foam && moves) {
    announce("foam: skipped, because the mesh model has no moving walls");
    options.foam = false;
  }

  const RunFolder folder{out};
  if (options.resume) require_same_case(folder, scene);
  if (!options.resume && !options.force) {
    refuse_to_replace(folder, "continue it with --resume, replace it with --force, or give another --out");
  }
  const std::vector<Stage> stages = stages_of(options, scene, out);
  for (const Stage& stage : stages) (void)stage_program(stage.name);  // throws before the first one runs
  int worst = static_cast<int>(Exit::done);
  for (const Stage& stage : stages) {
    announce(fmt::format("== thalweg {} {}", stage.name, fmt::join(stage.arguments, " ")));
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> command{stage_program(stage.name).string()};
    command.insert(command.end(), stage.arguments.begin(), stage.arguments.end());
    const int status = run_in_foreground(command);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const bool failed = status == static_cast<int>(Exit::run_failed) || status == static_cast<int>(Exit::input_wrong);
    if (failed && !stage.needed) {
      announce(fmt::format("== {} failed; the report does without it", stage.name));
      if (stage.name == "foam") worst = status;  // it was asked for; a coarser run is the report's own wish
      continue;
    }
    if (status != 0) {
      fmt::print(stderr, "thalweg run: {} ended with status {}; the stages after it were not run\n", stage.name,
                 status);
      return status;
    }
    announce(fmt::format("== {} done in {:.1f} s", stage.name, seconds));
  }
  announce(fmt::format("report: {}", (RunFolder{out}.report() / "index.html").string()));
  return worst;
}

}  // namespace thalweg
