#include "common/app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "case/reader/case_file.hpp"
#include "case/reader/differences.hpp"
#include "common/app/programs.hpp"
#include "common/console.hpp"
#include "common/error.hpp"
#include "common/io/run_results.hpp"
#include "common/process.hpp"
#include "common/run_folder.hpp"
#include "common/warnings.hpp"

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

Words set_words(const Words& overrides) {
  Words words;
  for (const std::string& text : overrides) words.insert(words.end(), {"--set", text});
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
  const Words overrides = set_words(options.overrides);
  std::vector<Stage> stages;
  add_run(stages, options, RunFolder{out}, overrides, scene.output.end, true);
  for (int run = 1, times = 2; run < scene.compare.runs; ++run, times *= 2) {
    const RunFolder folder = RunFolder{out}.coarser(times);
    const std::string spacing = fmt::format("numerics.spacing={} m", times * scene.numerics.spacing);
    add_run(stages, options, folder, with(overrides, {"--set", spacing}), scene.output.end, false);
    stages.push_back({"postproc", {folder.root.string()}, false});
  }
  for (int run = 1, times = 2; run < scene.compare.factor_runs; ++run, times *= 2) {
    const double spin_up = scene.surface_bed.spin_up;
    const double end = spin_up + times * (scene.output.end - spin_up);
    const Words slower{"--set", fmt::format("surface_bed.factor={}", scene.surface_bed.factor / times), "--set",
                       fmt::format("output.end={} s", end)};
    add_run(stages, options, RunFolder{out}.slower(times), with(overrides, slower), end, false);
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

/// The deepest files of a run stand in its foam folder, some 120 characters below the run's.
void require_short_path(const RunFolder& run) {
  constexpr std::size_t room = 200;
  const std::size_t length = std::filesystem::absolute(run.root).string().size();
  if (length + room <= PATH_MAX) return;
  throw InputError(
      fmt::format("{}...: the path of the run's folder has {} characters, and at most {} leave room for its "
                  "files; give a shorter --out",
                  run.root.string().substr(0, 40), length, PATH_MAX - room));
}

/// The reason why there is no mesh model of the scene here, in a line; empty if there is one. It costs a moment, where the
/// particles may take hours.
std::string reason_against_foam(const PipelineOptions& options, const Words& overrides) {
  if (!on_path("blockMesh")) return "OpenFOAM is not installed; get it with: apt-get install openfoam";
  const Words arguments{stage_program("foam").string(), options.case_path.string(), "--check"};
  ChildProcess foam(with(arguments, overrides), {.piped = STDERR_FILENO});
  std::string said;
  while (const auto line = foam.read_line()) said = *line;
  if (foam.wait() == 0) return "";
  constexpr std::string_view mark = "error: ";
  return said.starts_with(mark) ? said.substr(mark.size()) : said;
}

/// True for a stage that its own fault has ended, and no signal.
bool has_failed(int status) {
  return status == static_cast<int>(Exit::run_failed) || status == static_cast<int>(Exit::input_wrong);
}

/// The options of this program that hold for the stages too. Their results in JSON are not asked for: the pipeline has its own.
Words passed_on() {
  if (verbosity() == Verbosity::normal) return {};
  return {verbosity() == Verbosity::quiet ? "--quiet" : "--verbose"};
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

int run_stage(const Stage& stage) {
  say(fmt::format("== thalweg {} {}", stage.name, fmt::join(stage.arguments, " ")));
  const auto begin = std::chrono::steady_clock::now();
  const int status = run_in_foreground(with(with({stage_program(stage.name).string()}, stage.arguments), passed_on()),
                                       answers_in_json());
  if (status == 0) say(fmt::format("== {} done in {:.1f} s", stage.name, seconds_since(begin)));
  return status;
}

/// The stages that were run, for --json.
using Records = nlohmann::ordered_json;

/// Runs the stages in turn, and the report in any case: a mesh model or a run beside it that fails is a line in it.
int run_stages(const std::vector<Stage>& stages, const RunFolder& folder, Records& records) {
  int outcome = static_cast<int>(Exit::done);
  for (const Stage& stage : stages) {
    const auto begin = std::chrono::steady_clock::now();
    const int status = run_stage(stage);
    if (stage.name == "gencase" && stage.needed) keep_log(folder, "run");  // gencase begins the folder's log
    records.push_back({{"stage", stage.name}, {"status", status}, {"seconds", seconds_since(begin)}});
    if (status == 0) continue;
    if (stage.needed || !has_failed(status)) {
      const std::string ended =
          fmt::format("thalweg run: {} ended with status {}; the stages after it were not run", stage.name, status);
      log_line("error", ended);
      fmt::print(stderr, "{}\n", ended);
      return status;
    }
    const bool mesh = stage.name == "foam";
    const std::string what = mesh ? "" : fmt::format("{} of a run beside it ", stage.name);
    WarningFile(folder, mesh ? "foam" : "run")
        .add(fmt::format("{}failed with status {}; the report does without what is missing", what, status));
    say(fmt::format("== {} failed; the report does without it", stage.name));
    if (mesh) outcome = static_cast<int>(Exit::run_failed);
  }
  return outcome;
}

void tell_in_json(const RunFolder& folder, const Records& stages, int status) {
  nlohmann::ordered_json result{{"status", status}, {"folder", folder.root.string()}, {"stages", stages}};
  const std::filesystem::path report = folder.report() / "index.html";
  if (std::filesystem::exists(report)) result["report"] = report.string();
  result["summary"] = nlohmann::ordered_json::parse(summary_json(folder));
  result["warnings"] = warnings_of_programs(folder);
  if (status != 0) {
    for (const std::string& error : errors_in_log(folder))
      result["errors"].push_back(nlohmann::ordered_json::parse(error_json(error)));
  }
  set_result(result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

int run_pipeline(const PipelineOptions& given) {
  PipelineOptions options = given;
  const Case scene = read_case(options.case_path, options.overrides);
  const std::string out = (options.out.empty() ? std::filesystem::path("out") / scene.info.name : options.out).string();
  const RunFolder folder{out};
  require_short_path(folder);
  if (options.resume) {
    require_same_case(folder, scene);
    if (std::filesystem::exists(folder.root)) keep_log(folder, "run");
  }
  if (!options.resume && !options.force) {
    refuse_to_replace(folder, "continue it with --resume, replace it with --force, or give another --out");
  }
  std::string against_foam;
  if (options.foam) against_foam = reason_against_foam(options, set_words(options.overrides));
  if (!against_foam.empty()) {
    say("foam: left out: " + against_foam);
    options.foam = false;
  }
  std::vector<Stage> stages = stages_of(options, scene, out);
  for (const Stage& stage : stages) (void)stage_program(stage.name);  // throws before the first one runs
  const Stage report = stages.back();
  stages.pop_back();
  Records records = Records::array();
  const int outcome = run_stages(stages, folder, records);
  if (outcome != static_cast<int>(Exit::done) && outcome != static_cast<int>(Exit::run_failed)) {
    tell_in_json(folder, records, outcome);
    return outcome;
  }
  if (!against_foam.empty()) WarningFile(folder, "foam").add("left out: " + against_foam);
  const int drawn = run_stages({report}, folder, records);
  if (drawn == static_cast<int>(Exit::done)) say(fmt::format("report: {}", (folder.report() / "index.html").string()));
  const int status = drawn != static_cast<int>(Exit::done) ? drawn : outcome;
  tell_in_json(folder, records, status);
  return status;
}

}  // namespace thalweg
