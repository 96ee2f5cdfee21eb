#include "common/app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "case/reader/case_file.hpp"
#include "common/app/programs.hpp"
#include "common/error.hpp"
#include "common/process.hpp"
#include "common/run_folder.hpp"

namespace thalweg {
namespace {

struct Stage {
  std::string name;
  std::vector<std::string> arguments;
  bool needed = true;  // the pipeline ends if it fails
};

std::vector<Stage> stages_of(const PipelineOptions& options, const Case& scene, const std::string& out) {
  const std::string case_path = options.case_path.string();
  std::vector<std::string> overrides;
  for (const std::string& text : options.overrides) overrides.insert(overrides.end(), {"--set", text});
  const auto with = [](std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  std::vector<Stage> stages{{"gencase", with({case_path, "--out", out}, overrides)},
                            {"solver", with({out}, options.for_solver)}};
  for (int run = 1, times = 2; run < scene.compare.runs; ++run, times *= 2) {
    const std::string folder = RunFolder{out}.coarser(times).root.string();
    const std::string spacing = fmt::format("numerics.spacing={} m", times * scene.numerics.spacing);
    stages.push_back({"gencase", with(with({case_path, "--out", folder}, overrides), {"--set", spacing}), false});
    stages.push_back({"solver", with({folder}, options.for_solver), false});
    stages.push_back({"postproc", {folder}, false});
  }
  if (options.foam) stages.push_back({"foam", with({case_path, "--out", out}, overrides)});
  stages.push_back({"postproc", {out, "--report"}});
  return stages;
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

  const std::vector<Stage> stages = stages_of(options, scene, out);
  for (const Stage& stage : stages) (void)stage_program(stage.name);  // throws before the first one runs
  for (const Stage& stage : stages) {
    announce(fmt::format("== thalweg {} {}", stage.name, fmt::join(stage.arguments, " ")));
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> command{stage_program(stage.name).string()};
    command.insert(command.end(), stage.arguments.begin(), stage.arguments.end());
    const int status = run_in_foreground(command);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (status == static_cast<int>(Exit::run_failed) && !stage.needed) {
      announce(fmt::format("== {} failed; the report does without this coarser run", stage.name));
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
  return static_cast<int>(Exit::done);
}

}  // namespace thalweg
