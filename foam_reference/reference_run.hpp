#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "foam_reference/case_files.hpp"
#include "foam_reference/foam_run.hpp"

namespace thalweg::foam {

/// Takes a warning, one line.
using Warn = std::function<void(const std::string&)>;

/// Outcome of reference_run.
enum class Reference { computed, already_there };

/// Runs the mesh model of a case in `folder` (RunFolder::foam(), or another one for a second mesh):
///   case/         the OpenFOAM case, which ParaView opens through case/case.foam and case/Allrun repeats
///   profiles/     the elevations at compare.times (common/profile.hpp)
///   history.csv   volumes of the phases and the continuity error at every step
///   summary.csv   what was run, what it cost, how well volumes were kept
/// A finished run of exactly these dictionaries is not repeated; profiles that it lacks are sampled.
/// Throws InputError (also without OpenFOAM), RunError, Interrupted.
Reference reference_run(const FoamCase& foam_case, const std::filesystem::path& folder, const Warn& warn);

/// Volumes [m^3] (2-D: [m^3/m]) of one phase over a run.
struct VolumeBalance {
  std::string phase;
  double start = 0;
  double end = 0;
  double outflow = 0;  // through open faces

  /// Volume that has appeared or vanished, outflow apart, over that at the start; 0 for a phase that was not there.
  [[nodiscard]] double relative_error() const { return start > 0 ? (end + outflow - start) / start : 0; }
};

/// Relative error of a volume above which a warning is printed.
inline constexpr double volume_tolerance = 1e-3;

/// Reads a finished run's fields at compare.times and writes them as `folder`/profiles.
void write_profiles(const FoamCase& foam_case, const std::filesystem::path& folder);

/// Reads a finished run's fields and writes `folder`/profiles, history.csv and summary.csv.
/// Returns the balances of water and, if there is any, sediment.
std::vector<VolumeBalance> write_results(const FoamCase& foam_case, const std::filesystem::path& folder,
                                         const FoamRun& run);

}  // namespace thalweg::foam
