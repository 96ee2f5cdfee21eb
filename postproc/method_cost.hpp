#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/run_folder.hpp"
#include "postproc/profile_set.hpp"
#include "postproc/run_records.hpp"

namespace thalweg {

/// A computation at one resolution: the particle model at a spacing, or a mesh model at a cell size.
struct MethodRun {
  std::string label;       // "particles 5 mm", "same-material 10 mm"
  double resolution = 0;   // [m]
  double elements = 0;     // fluid particles or cells
  double steps = 0;        // [-]
  double cpu_seconds = 0;  // [s]
  ProfileSet profiles;
  double error_free_surface = 0;  // [m] root mean square from the finest run of the same method; 0: it is the finest
  double error_bed = 0;           // [m]

  [[nodiscard]] double element_steps_per_second() const { return elements * steps / cpu_seconds; }
};

/// One method at all resolutions at hand, the finest first.
struct Method {
  std::string name;  // "particles", "same-material", …
  std::vector<MethodRun> runs;
};

/// The particle model in `run` and in its coarser runs, and every mesh model in run/foam with its coarser meshes.
/// Only runs with a summary and profiles count. Throws InputError.
std::vector<Method> read_methods(const RunFolder& run);

/// True if a folder of run/foam holds a model of another folder on a coarser mesh ("same-material-2x").
bool is_coarser_mesh(const std::filesystem::path& folder);

/// Root mean square distance [m] of a curve between two sets over all times they share; NaN where they share none.
double distance(const ProfileSet& finest, const ProfileSet& coarser, const Curve& curve);

/// cost.csv: every run of every method. Throws RunError.
void write_costs(const std::filesystem::path& file, const std::vector<Method>& methods);

}  // namespace thalweg
