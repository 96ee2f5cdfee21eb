#pragma once

#include <filesystem>
#include <string>

#include "foam_reference/solver_log.hpp"

namespace thalweg::foam {

/// Cost and steps of a finished run.
struct FoamRun {
  double cpu_seconds = 0;  // of all programs Allrun called, all ranks
  double wall_seconds = 0;
  std::string openfoam_version;
  std::vector<SolverStep> steps;
};

/// The run was ended by Ctrl-C or SIGTERM; `signal` tells by which.
struct Interrupted {
  int signal = 0;
};

/// Throws InputError that tells how to get OpenFOAM if its programs are not on PATH.
void require_openfoam();

/// Runs Allrun in `folder`, whose solver is `application`, until `end` [s], with progress on stderr. Throws RunError
/// that tells the time of a failure, the log to read and the cure to try; throws Interrupted.
FoamRun run_foam(const std::filesystem::path& folder, double end,
                 const std::string& application = "multiphaseInterFoam");

}  // namespace thalweg::foam
