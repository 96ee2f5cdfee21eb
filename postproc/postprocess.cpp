#include "postproc/postprocess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "common/case_file.hpp"
#include "common/run_folder.hpp"
#include "postproc/comparison.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/report.hpp"
#include "postproc/run_records.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

RunFolder existing_run(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string() +
                     ": there is no such folder; give the folder of a run (thalweg run CASE --out DIR)");
  }
  const RunFolder run{folder};
  if (!fs::exists(run.resolved_case())) {
    throw InputError(folder.string() +
                     ": is not the folder of a run, it holds no case.resolved.toml; make one with "
                     "thalweg-gencase CASE --out " +
                     folder.string());
  }
  return run;
}

// "OpenFOAM", with its model and cell size where it says them, so that two of them can be told apart.
MeshModel mesh_model(const fs::path& folder, const std::string& otherwise) {
  MeshModel mesh{"OpenFOAM", read_quantities(folder / "summary.csv")};
  if (const std::optional<std::string> model = text_of(mesh.summary, "mesh_model")) mesh.label += " " + *model;
  if (const std::optional<double> cell = number_of(mesh.summary, "cell_size")) {
    mesh.label += fmt::format(" {:g} mm", 1e3 * *cell);
  } else if (!otherwise.empty()) {
    mesh.label += " " + otherwise;
  }
  return mesh;
}

void add_mesh_models(const RunFolder& run, ReportInput& input) {
  std::vector<std::pair<fs::path, std::string>> folders{{run.foam(), ""}};
  if (fs::is_directory(run.foam())) {
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(run.foam())) inside.push_back(entry.path());
    std::sort(inside.begin(), inside.end());
    for (const fs::path& path : inside) folders.emplace_back(path, path.filename().string());
  }
  for (const auto& [folder, name] : folders) {
    if (!holds_profiles(folder / "profiles") || is_coarser_mesh(folder)) continue;  // report_methods.cpp shows those
    MeshModel mesh = mesh_model(folder, name);
    const bool known = std::any_of(input.sets.begin(), input.sets.end(),
                                   [&](const ProfileSet& set) { return set.label == mesh.label; });
    if (known) mesh.label += " (" + name + ")";
    input.sets.push_back(read_profile_set(folder / "profiles", mesh.label, SourceKind::mesh));
    if (!mesh.summary.empty()) input.meshes.push_back(std::move(mesh));
  }
}

// A path as a reader would type it: relative to where the program was started, if it lies below.
std::string short_name(const fs::path& path) {
  const fs::path relative = fs::proximate(path);
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

void add_measurements(const Case& resolved, ReportInput& input) {
  std::vector<std::string> slots = resolved.compare.references;
  if (slots.empty()) slots.emplace_back("reference");  // the usual place, docs/case-file.md
  for (const std::string& slot : slots) {
    const fs::path folder = resolved.folder / slot;
    if (!fs::exists(folder) || (fs::is_directory(folder) && !holds_profiles(folder))) {
      input.reference_notes.push_back("no measured profiles: " + short_name(folder) +
                                      (fs::exists(folder) ? " is empty" : " does not exist"));
      continue;
    }
    const std::string label = slots.size() == 1 ? "measured" : "measured, " + fs::path(slot).filename().string();
    input.sets.push_back(read_profile_set(folder, label, SourceKind::measured));
  }
}

void warn(const std::string& message) { fmt::print(stderr, "warning: {}\n", message); }

}  // namespace

Exit postprocess(const PostprocessOptions& options) {
  const RunFolder run = existing_run(options.folder);
  ReportInput input;
  input.run = run;
  input.resolved = read_case(run.resolved_case());
  input.compare_arguments = options.compare;
  std::vector<ProfileSet> named = read_named_sets(options.compare);  // before the work: a wrong name costs no waiting

  input.extraction = extract_run(run, input.resolved);
  input.warnings = input.extraction.warnings;
  fmt::print("{} snapshots, {} profiles in {}\n", input.extraction.fronts.size(), input.extraction.written.size(),
             run.profiles().string());

  input.sets.push_back({"Thalweg SPH", SourceKind::run, run.profiles(), input.extraction.written});
  add_mesh_models(run, input);
  std::move(named.begin(), named.end(), std::back_inserter(input.sets));
  add_measurements(input.resolved, input);
  const Compare& range = input.resolved.compare;
  const double infinite = std::numeric_limits<double>::infinity();
  input.comparison = range.to > range.from ? compare_all(input.sets, range.from, range.to)
                                           : compare_all(input.sets, -infinite, infinite);
  for (const std::string& note : input.reference_notes) fmt::print("{}\n", note);
  fmt::print("{}", table_of(input.comparison));
  for (const std::string& remark : input.comparison.remarks) fmt::print("  {}\n", remark);
  write_errors(run.report() / "errors.csv", input.comparison);

  bool complete = !input.extraction.damaged;
  if (options.report) {
    const fs::path repeatability = input.resolved.folder / "repeatability.csv";
    input.repeatability = read_repeatability(repeatability);
    if (!input.repeatability.empty()) input.repeatability_origin = comments_in(repeatability);
    input.history = read_history(run.history());
    input.timing = read_timing(run.timing());
    input.summary = read_quantities(run.summary());
    input.methods = read_methods(run);
    write_costs(run.report() / "cost.csv", input.methods);
    for (const auto& file : {run.history(), run.timing(), run.summary()}) {
      if (!fs::exists(file)) input.warnings.push_back(file.string() + ": is missing; the report leaves its part out");
    }
    if (!write_report(input)) {
      input.warnings.emplace_back("gnuplot is not installed, so there are no pictures; apt-get install gnuplot-nox");
      complete = false;
    }
    fmt::print("\nreport: {}\n", (run.report() / "index.html").string());
  }
  for (const std::string& warning : input.warnings) warn(warning);
  return complete ? Exit::done : Exit::run_failed;
}

}  // namespace thalweg
