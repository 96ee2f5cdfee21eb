#pragma once

#include <filesystem>
#include <string>

#include "foam_reference/solver_log.hpp"

namespace thalweg::foam {

/// What a finished run cost and reported.
struct FoamRun {
  double cpu_seconds = 0;  // of all programs Allrun called, all ranks
  double wall_seconds = 0;
  std::string openfoam_version;
  std::vector<SolverStep> steps;
};

/// Ended by Ctrl-C or SIGTERM; `signal` says which.
struct Interrupted {
  int signal = 0;
};

/// Throws InputError saying how to get OpenFOAM when its programs are not on PATH.
void require_openfoam();

/// Runs Allrun in `folder`, whose solver is `application`, until `end` [s], with progress on stderr. Throws RunError
/// that says at which time it failed, which log to read and what to try; throws Interrupted.
FoamRun run_foam(const std::filesystem::path& folder, double end,
                 const std::string& application = "multiphaseInterFoam");

}  // namespace thalweg::foam
