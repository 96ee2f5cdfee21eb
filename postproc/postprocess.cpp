#include "postproc/postprocess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "case/reader/case_file.hpp"
#include "common/run_folder.hpp"
#include "common/whole_file.hpp"
#include "postproc/comparison.hpp"
#include "postproc/embedded.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/line_profile.hpp"
#include "postproc/movie.hpp"
#include "postproc/paper_figures.hpp"
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

constexpr const char* run_label = "Thalweg SPH";

// A source's profiles along a line. Of the run itself: those at the times it is compared at, and the one at 0 s.
std::optional<ProfileSet> set_along(const std::string& line, const ProfileSet& source,
                                    const ExtractionRun& extraction) {
  if (source.kind != SourceKind::run) return read_line_set(source, line);
  const auto found = extraction.along_lines.find(line);
  if (found == extraction.along_lines.end()) return std::nullopt;
  ProfileSet set{source.label, source.kind, source.origin / line, {}, {}, line};
  for (const SnapshotProfile& snapshot : found->second) {
    const bool is_initial = !set.initial && std::abs(snapshot.time) <= same_time;
    const bool is_compared = source.at(snapshot.time) != nullptr;
    if (is_initial) set.initial = snapshot.get();
    if (is_compared) set.profiles.push_back(snapshot.get());
  }
  return set;
}

// What runs that should agree differ by: as measured for the case, or of the runs given.
std::vector<Scatter> scatter_of_run(const ReportInput& input, const std::string& line,
                                    const std::vector<std::string>& repeats) {
  std::vector<Scatter> scatter;
  if (repeats.empty()) {
    for (const Repeatability& known : input.repeatability)
      scatter.push_back({"", known.curve, known.time, known.rms, 0});
    return scatter;
  }
  std::vector<ProfileSet> repeated{input.sets.front()};
  for (const std::string& folder : repeats) repeated.push_back(read_profile_set(folder, run_label, SourceKind::other));
  if (line.empty()) return scatter_of(repeated);
  std::vector<ProfileSet> along;
  for (const ProfileSet& set : repeated) {
    std::optional<ProfileSet> of_line = set_along(line, set, input.extraction);
    if (of_line) along.push_back(std::move(*of_line));
  }
  return scatter_of(along);
}

void compare_sources(ReportInput& input, const std::vector<ProfileLine>& further_lines,
                     const std::vector<std::string>& repeats) {
  const fs::path repeatability = input.resolved.folder / "repeatability.csv";
  input.repeatability = read_repeatability(repeatability);
  if (!input.repeatability.empty()) input.repeatability_origin = comments_in(repeatability);

  ComparedRange range;
  range.least_depth = least_layer * input.extraction.info.spacing;
  ComparedRange along_x = range;
  if (input.resolved.compare.to > input.resolved.compare.from) {
    along_x.from = input.resolved.compare.from;
    along_x.to = input.resolved.compare.to;
  }
  input.comparison = compare_all(input.sets, along_x);
  add_scatter(input.comparison, run_label, scatter_of_run(input, "", repeats));

  std::vector<ProfileLine> lines = input.resolved.lines;
  lines.insert(lines.end(), further_lines.begin(), further_lines.end());
  for (const ProfileLine& line : lines) {
    std::vector<ProfileSet> sets;
    for (const ProfileSet& source : input.sets) {
      std::optional<ProfileSet> set = set_along(line.name, source, input.extraction);
      if (set) sets.push_back(std::move(*set));
    }
    Comparison along = compare_all(sets, range);
    add_scatter(along, run_label, scatter_of_run(input, line.name, repeats));
    if (sets.size() < 2) along.remarks.push_back("line " + line.name + ": only the run has profiles along it");
    Comparison& all = input.comparison;
    std::move(along.errors.begin(), along.errors.end(), std::back_inserter(all.errors));
    std::move(along.scalars.begin(), along.scalars.end(), std::back_inserter(all.scalars));
    std::move(along.remarks.begin(), along.remarks.end(), std::back_inserter(all.remarks));
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

  ExtractionOptions extraction{{}, options.surfaces};
  for (const std::string& line : options.lines) {
    extraction.lines.push_back(parse_line(line));
    if (input.resolved.info.dimension == 2) throw InputError("--line " + line + ": a 2-D run has one profile, along x");
  }
  input.extraction = extract_run(run, input.resolved, extraction);
  input.warnings = input.extraction.warnings;
  write_whole_text(run.view_script(), [](std::ostream& stream) { stream << embedded::view_script; });
  fmt::print(
      "{} snapshots{}, {} profiles in {}\n", input.extraction.fronts.size(),
      input.extraction.reused > 0 ? fmt::format(" ({} as an earlier pass left them)", input.extraction.reused) : "",
      input.extraction.written.size(), run.profiles().string());

  input.sets.push_back(
      {run_label, SourceKind::run, run.profiles(), input.extraction.written, input.extraction.initial});
  add_mesh_models(run, input);
  std::move(named.begin(), named.end(), std::back_inserter(input.sets));
  add_measurements(input.resolved, input);
  compare_sources(input, extraction.lines, options.repeats);
  for (const std::string& note : input.reference_notes) fmt::print("{}\n", note);
  fmt::print("{}", table_of(input.comparison));
  for (const std::string& remark : input.comparison.remarks) fmt::print("  {}\n", remark);
  write_errors(run.report(), input.comparison);

  bool complete = !input.extraction.damaged;
  if (options.paper_figures) fmt::print("\nfigures: {}\n", write_paper_figures(input, options.series).string());
  if (options.movie) {
    const Movie movie = make_movie(run, input.resolved);
    complete = complete && movie.frames > 0;
    if (movie.frames > 0) {
      fmt::print("\nmovie: {} frames in {}{}\n", movie.frames, (run.root / "movie").string(),
                 movie.film.empty() ? "" : ", " + movie.film.string());
    }
    input.warnings.insert(input.warnings.end(), movie.warnings.begin(), movie.warnings.end());
  }
  if (options.report || options.in_space) {
    input.in_space = options.in_space;
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
