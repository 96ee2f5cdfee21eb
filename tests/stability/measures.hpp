#pragma once

#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/csv.hpp"
#include "common/particles.hpp"

namespace thalweg::test {

/// The files of a run, as its measures need them.
struct FinishedRun {
  Case scene;
  ParticleSet start;
  std::vector<ParticleSet> snapshots;  // in order of time, the last at the end
  CsvTable history;
  double steps = 0;
  double fluid_particles = 0;
  double cpu_seconds = 0;

  [[nodiscard]] const ParticleSet& end() const { return snapshots.back(); }
};

/// Reads the folder of a run. Throws InputError when a file is missing.
FinishedRun read_run(const Case& scene, const ParticleSet& start, const std::filesystem::path& folder);

/// A number that says how well a run went.
struct Measure {
  std::string unit;
  std::string meaning;
  double (*of)(const FinishedRun&);
};

/// All measures by the names that suite.toml uses.
const std::map<std::string, Measure>& measures();

/// Number of particles with a value that is not finite.
double count_not_finite(const ParticleSet& particles);

}  // namespace thalweg::test
