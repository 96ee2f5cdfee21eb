#include "postproc/method_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "postproc/comparison.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

struct Names {
  const char* resolution;
  const char* elements;
};
constexpr Names of_particles{"spacing", "fluid_particles"};
constexpr Names of_mesh{"cell_size", "cells"};

// Reads the run of a folder; nothing if it holds no finished run.
std::optional<MethodRun> read_run(const fs::path& folder, const std::string& method, const Names& names,
                                  SourceKind kind) {
  const std::vector<Quantity> summary = read_quantities(folder / "summary.csv");
  if (summary.empty() || !holds_profiles(folder / "profiles")) return std::nullopt;
  const auto number = [&](const char* name) { return number_of(summary, name).value_or(0); };
  MethodRun run;
  run.resolution = number(names.resolution);
  run.elements = number(names.elements);
  run.steps = number("steps");
  run.cpu_seconds = number("cpu_seconds");
  if (run.resolution <= 0 || run.cpu_seconds <= 0) return std::nullopt;
  run.label = fmt::format("{} {:g} mm", method, 1e3 * run.resolution);
  run.profiles = read_profile_set(folder / "profiles", run.label, kind);
  return run;
}

void compare_with_finest(Method& method) {
  std::ranges::sort(method.runs, {}, &MethodRun::resolution);
  for (MethodRun& run : method.runs) {
    if (&run == &method.runs.front()) continue;
    run.error_free_surface = distance(method.runs.front().profiles, run.profiles, curves[0]);
    run.error_bed = distance(method.runs.front().profiles, run.profiles, curves[1]);
  }
}

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

bool is_coarser_mesh(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const std::size_t dash = name.rfind('-');
  if (dash == std::string::npos || dash == 0 || !name.ends_with('x')) return false;
  const std::string times = name.substr(dash + 1, name.size() - dash - 2);
  return !times.empty() && std::ranges::all_of(times, [](unsigned char c) { return std::isdigit(c) != 0; });
}

double distance(const ProfileSet& finest, const ProfileSet& coarser, const Curve& curve) {
  double sum = 0;
  std::size_t points = 0;
  for (const CurveError& error : compare(finest, coarser, ComparedRange{}).errors) {
    if (error.curve != curve.name) continue;
    sum += error.rmse * error.rmse * static_cast<double>(error.points);
    points += error.points;
  }
  return points > 0 ? std::sqrt(sum / static_cast<double>(points)) : Profile::missing;
}

std::vector<Method> read_methods(const RunFolder& run) {
  std::vector<Method> methods;
  Method particles{"particles", {}};
  std::vector<fs::path> folders = folders_in(run.root / "coarser");
  folders.insert(folders.begin(), run.root);
  for (const fs::path& folder : folders) {
    if (auto found = read_run(folder, particles.name, of_particles, SourceKind::run)) {
      particles.runs.push_back(std::move(*found));
    }
  }
  if (!particles.runs.empty()) methods.push_back(std::move(particles));

  std::map<std::string, Method> meshes;
  for (const fs::path& folder : folders_in(run.foam())) {
    std::string name = folder.filename().string();
    if (is_coarser_mesh(folder)) name.resize(name.rfind('-'));
    if (auto found = read_run(folder, name, of_mesh, SourceKind::mesh)) {
      meshes[name].name = name;
      meshes[name].runs.push_back(std::move(*found));
    }
  }
  for (auto& [name, method] : meshes) methods.push_back(std::move(method));
  for (Method& method : methods) compare_with_finest(method);
  return methods;
}

void write_costs(const fs::path& file, const std::vector<Method>& methods) {
  CsvTable table({{"method", ""},
                  {"resolution", "m"},
                  {"elements", "-"},
                  {"steps", "-"},
                  {"cpu", "s"},
                  {"element_steps_per_second", "1/s"},
                  {"error_free_surface", "m"},
                  {"error_bed", "m"}});
  table.comments.emplace_back(
      "elements: fluid particles or cells; cpu: of all threads and ranks, the mesh's making included");
  table.comments.emplace_back(
      "errors: root mean square from the finest run of the same method; empty: it is the finest");
  for (const Method& method : methods) {
    for (const MethodRun& run : method.runs) {
      const bool finest = &run == &method.runs.front();
      table.add_row({method.name, csv_number(run.resolution), csv_number(run.elements), csv_number(run.steps),
                     csv_number(run.cpu_seconds), csv_number(run.element_steps_per_second()),
                     finest ? "" : csv_number(run.error_free_surface), finest ? "" : csv_number(run.error_bed)});
    }
  }
  table.write(file);
}

}  // namespace thalweg
