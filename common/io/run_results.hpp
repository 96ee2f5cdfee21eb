#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/io/series.hpp"
#include "common/run_folder.hpp"

// Results that a run folder holds already: what a second run would destroy, and what a continued one goes on with.
namespace thalweg {

/// The time [s] up to which a folder holds results of a run; nothing if it holds none beyond the start.
std::optional<double> time_reached(const RunFolder& run);

/// summary.csv as a JSON object {QUANTITY: {"value", "unit"}}, numbers as numbers; "{}" if there is none.
std::string summary_json(const RunFolder& run);

/// Throws InputError if the folder holds results, naming `cure`.
void refuse_to_replace(const RunFolder& run, const std::string& cure);

/// Removes the solver's results, so that a fresh run starts from an empty folder. What other programs have made stays.
void remove_results(const RunFolder& run);

/// The snapshots up to a time [s] that are there, in order of time: those of the series, and where that is missing or
/// damaged those of the folder, by the times they hold.
std::vector<SeriesEntry> snapshots_until(const RunFolder& run, double time);

}  // namespace thalweg
