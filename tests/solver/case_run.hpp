#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "gencase/generate.hpp"
#include "solver/program/run.hpp"

// Runs one of the project's own cases in a folder of the test's own, as the programs would.
namespace thalweg::test {

/// Folder of one of the project's cases, or of a bundle's (tools/bundle).
inline std::filesystem::path case_folder(const std::string& case_name) {
  const char* cases = std::getenv("THALWEG_CASES");
  return std::filesystem::path(cases == nullptr ? THALWEG_SOURCE_DIR "/cases" : cases) / case_name;
}

/// The folder carries the process's number: CTest runs every test as a process of its own, several at a time.
class CaseRun {
 public:
  explicit CaseRun(const std::string& name)
      : folder_{std::filesystem::path(testing::TempDir()) / ("thalweg_" + name + "_" + std::to_string(getpid()))} {
    std::filesystem::remove_all(folder_.root);
    std::filesystem::create_directories(folder_.root);
  }
  ~CaseRun() { std::filesystem::remove_all(folder_.root); }
  CaseRun(const CaseRun&) = delete;
  CaseRun& operator=(const CaseRun&) = delete;

  void fill(const std::string& case_name, const std::vector<std::string>& overrides) {
    fill_from(case_folder(case_name), overrides);
  }
  void fill_from(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    gencase::Generated scene = gencase::generate(read_case(path, overrides));
    write_case(folder_.resolved_case(), scene.resolved);
    write_particles(folder_.particles(), scene.particles, PositionPrecision::double_precision);
    start_ = std::move(scene.particles);
    case_ = std::move(scene.resolved);
  }

  RunOptions options() const {
    RunOptions o;
    o.folder = folder_.root;
    return o;
  }

  ParticleSet snapshot_at(double time) const {
    for (const SeriesEntry& e : read_series(folder_.snapshot_series())) {
      if (std::abs(e.time - time) < 1e-6) return read_particles(folder_.root / e.file);
    }
    ADD_FAILURE() << "no snapshot at t = " << time << " s";
    return {};
  }

  const RunFolder& folder() const { return folder_; }
  const ParticleSet& start() const { return start_; }
  const Case& scene() const { return case_; }

 private:
  RunFolder folder_;
  ParticleSet start_;
  Case case_;
};

}  // namespace thalweg::test
