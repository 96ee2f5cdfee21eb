#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/csv.hpp"
#include "foam_reference/case_files.hpp"
#include "foam_reference/solver_log.hpp"

namespace thalweg::foam {

/// Columns that a current adds to history.csv, with a value for each step. They are those of the particles' history.csv:
///   NAME_water, NAME_sediment  [kg]  what has come in through an opening since the start; gone out: negative
///   NAME_level                 [m]   level of the water in its plane; missing where it does not stand upright
///   bulk_velocity              [m/s] mean over the water at the step's begin, drive [m/s^2] its acceleration
/// Grains cross an opening of the eroding bed with the water alone; they are known together, and stand with the one
/// outlet, or are missing where there are more.
struct CurrentRecords {
  std::vector<CsvColumn> columns;
  std::vector<std::vector<double>> values;  // for each column
};

/// `grains_left`: volume of the grains that have left [m^3], for each step; empty without an eroding bed.
/// Throws RunError if a table is missing in the run's folder.
CurrentRecords current_records(const FoamCase& foam_case, const std::filesystem::path& folder,
                               const std::vector<SolverStep>& steps, const std::vector<double>& grains_left);

/// Volume [m^3] of a phase that has left through all patches that it can cross, less what came in.
double outflow(const FoamCase& foam_case, const std::filesystem::path& folder, const std::string& phase,
               const std::vector<SolverStep>& steps);

}  // namespace thalweg::foam
