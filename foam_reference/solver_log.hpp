#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace thalweg::foam {

/// One time step as OpenFOAM's solvers report it.
struct SolverStep {
  double time = 0;              // [s]
  double dt = 0;                // [s]
  double continuity_error = 0;  // [-] summed over all steps so far, signed
};

/// Follows the solver's log while it grows.
class SolverLog {
 public:
  explicit SolverLog(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads the lines written since the last call. A log that does not exist yet counts as empty.
  void read_on();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::vector<SolverStep>& steps() const { return steps_; }
  [[nodiscard]] const std::string& version() const { return version_; }  // "1912 (patch=200626)"

 private:
  void read_line(const std::string& line);

  std::filesystem::path file_;
  std::ifstream stream_;
  std::string rest_;  // the last line, as far as it has been written
  std::vector<SolverStep> steps_;
  std::string version_;
  double dt_ = 0;
};

/// The reason that a program of OpenFOAM gives in its log for its failure, on one line; empty if it gives none.
std::string fatal_message(const std::filesystem::path& log);

}  // namespace thalweg::foam
