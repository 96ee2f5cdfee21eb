#include "postproc/report_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "postproc/comparison.hpp"
#include "postproc/method_cost.hpp"
#include "postproc/run_records.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// "OpenFOAM", with its model and cell size where it says them, so that two of them can be told apart.
MeshModel mesh_model(const fs::path& folder, const std::string& otherwise) {
  MeshModel mesh{"OpenFOAM", read_quantities(folder / "summary.csv"), {}, {}};
  if (const std::optional<std::string> model = text_of(mesh.summary, "mesh_model")) mesh.label += " " + *model;
  if (const std::optional<double> cell = number_of(mesh.summary, "cell_size")) {
    mesh.label += fmt::format(" {:g} mm", 1e3 * *cell);
  } else if (!otherwise.empty()) {
    mesh.label += " " + otherwise;
  }
  return mesh;
}

// A path as a reader would type it: relative to where the program was started, if it lies below.
std::string short_name(const fs::path& path) {
  const fs::path relative = fs::proximate(path);
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

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

// The scatter of equal runs: as measured for the case or, if repeated runs are given, between these.
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

// True if something was measured along one of the lines: reference/NAME/t0.250.csv.
bool has_profiles_along(const std::vector<ProfileLine>& lines, const fs::path& folder) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const ProfileLine& line) { return holds_profiles(folder / line.name); });
}

void append(Comparison& all, Comparison&& more) {
  std::move(more.errors.begin(), more.errors.end(), std::back_inserter(all.errors));
  std::move(more.scalars.begin(), more.scalars.end(), std::back_inserter(all.scalars));
  std::move(more.remarks.begin(), more.remarks.end(), std::back_inserter(all.remarks));
}

}  // namespace

void add_mesh_models(ReportInput& input) {
  const RunFolder& run = input.run;
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
    mesh.openings = read_openings(input.resolved, folder / "history.csv");
    mesh.stations = read_velocity_stations(folder / "stations.csv");
    input.sets.push_back(read_profile_set(folder / "profiles", mesh.label, SourceKind::mesh));
    if (!mesh.summary.empty()) input.meshes.push_back(std::move(mesh));
  }
}

void add_measurements(ReportInput& input) {
  const Case& resolved = input.resolved;
  std::vector<std::string> slots = resolved.compare.references;
  if (slots.empty()) slots.emplace_back("reference");  // the usual place, docs/case-file.md
  for (const std::string& slot : slots) {
    const fs::path folder = resolved.folder / slot;
    const std::string label = slots.size() == 1 ? "measured" : "measured, " + fs::path(slot).filename().string();
    const bool lacks_profiles = fs::is_directory(folder) && !holds_profiles(folder);
    if (lacks_profiles && has_profiles_along(resolved.lines, folder)) {
      input.line_sources.push_back({label, SourceKind::measured, folder, {}});
      continue;
    }
    if (lacks_profiles || !fs::exists(folder)) {
      const char* why = !fs::exists(folder)    ? " does not exist"
                        : fs::is_empty(folder) ? " is empty"
                                               : " holds none (t0.500.csv)";
      input.reference_notes.push_back("no measured profiles: " + short_name(folder) + why);
      continue;
    }
    input.sets.push_back(read_profile_set(folder, label, SourceKind::measured));
  }
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
    for (const std::vector<ProfileSet>* sources : {&input.sets, &input.line_sources}) {
      for (const ProfileSet& source : *sources) {
        std::optional<ProfileSet> set = set_along(line.name, source, input.extraction);
        if (set) sets.push_back(std::move(*set));
      }
    }
    Comparison along = compare_all(sets, range);
    add_scatter(along, run_label, scatter_of_run(input, line.name, repeats));
    if (sets.size() < 2) along.remarks.push_back("line " + line.name + ": only the run has profiles along it");
    append(input.comparison, std::move(along));
  }
}

}  // namespace thalweg
