#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/equilibrium_fit.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

/// The hole in a bed that is a surface, over the bed's own time: the largest fall of a column since the start.
struct ScourRecord {
  std::vector<double> time;   // [s] of the bed, at each bed step
  std::vector<double> depth;  // [m]
  std::vector<double> x;      // [m] of the deepest place
  std::vector<double> y;      // [m]
  std::vector<double> water;  // [s] time of the water
  double water_time = 0;      // [s] that the water was computed for
  double fed = 0;             // [m^3] volume of grains that came in (2-D: [m^2])
  double left = 0;            // [m^3] and that went out
  long steps = 0;             // of the bed
  long unsettled = 0;         // of these, under a stress that had not settled
  EquilibriumFit fit;
};

/// The hole of a run beside the main one, with another factor or spacing.
struct ScourCheck {
  std::string label;        // "factor 2", "spacing 10 mm"
  bool of_spacing = false;  // and not of the factor
  ScourRecord record;
  double time = 0;     // [s] of the bed, the latest that both runs have
  double depth = 0;    // [m] at that time, in this run
  double of_main = 0;  // [m] and in the main one
};

/// The runs in `slower` and `coarser` below the run's folder (compare.factor_runs, compare.runs) that have a hole.
std::vector<ScourCheck> read_scour_checks(const RunFolder& run, const ScourRecord& main);

/// Depth of the hole [m] at a time [s] of the bed, linear between bed steps.
double scour_at(const ScourRecord& record, double time);

/// The bed's time [s] when the water's is `time` [s].
double bed_time_at(const ScourRecord& record, double time);

/// Reads it from history.csv; without times for other beds, and before the first bed step. Throws InputError.
ScourRecord read_scour(const Case& of, const std::filesystem::path& history);

/// Writes time [s], depth [m] from the start on, and the fitted curve [m] where the equilibrium was reached.
void write_scour(const std::filesystem::path& file, const ScourRecord& record);

}  // namespace thalweg
