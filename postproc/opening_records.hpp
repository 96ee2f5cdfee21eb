#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// An inlet or outlet over a run. Rates are volumes of water per time into the scene [m^3/s] (2-D: [m^2/s]), negative
/// where it leaves.
struct OpeningRecord {
  std::string name;
  bool enters = false;
  std::vector<double> rate;   // in windows of time
  std::vector<double> level;  // [m] mean over them; NaN where it does not stand upright
  double water = 0;           // [kg] in the end, that came in less what went out
  double sediment = 0;        // [kg]
  double mean_rate = 0;       // of the last half of the run, by a straight line through the sums
  double mean_level = 0;      // [m]
};

/// The openings of a run.
struct OpeningRecords {
  std::vector<double> time;  // [s] middles of the windows
  std::vector<OpeningRecord> openings;
};

/// Reads them from history.csv; none without openings or with too few rows. Water passes an opening particle by particle,
/// so that rates are means over windows, fifty of them over the run. Throws InputError.
OpeningRecords read_openings(const Case& of, const std::filesystem::path& history);

/// Writes the windows as a table: time [s], and for each opening NAME_rate [m^3/s] (2-D: [m^2/s]) and NAME_level [m].
void write_openings(const std::filesystem::path& file, const OpeningRecords& records, int dimension);

}  // namespace thalweg
