#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/app/scour/rows.hpp"
#include "common/run_folder.hpp"
#include "postproc/comparison.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/method_cost.hpp"
#include "postproc/opening_records.hpp"
#include "postproc/report_units.hpp"
#include "postproc/run_bed_map.hpp"
#include "postproc/run_records.hpp"
#include "postproc/scour_record.hpp"
#include "postproc/scour_summary.hpp"
#include "postproc/velocity_stations.hpp"

namespace thalweg {

/// A mesh model beside the run.
struct MeshModel {
  std::string label;
  std::vector<Quantity> summary;
  OpeningRecords openings;                // of its own history.csv
  std::vector<VelocityStation> stations;  // of its stations.csv
};

/// A table of the bed's rise (+) or fall (-) since the run's first profile, at every place and time with a profile.
struct BedHistory {
  // x [m], time [s], from [s], to [s], change [m]; from and to lie half-way to the neighbouring times
  std::filesystem::path file;
  std::size_t times = 0;  // [-] 0: there is no table, because the run has no bed or a single time
  double largest = 0;     // [m] magnitude
};

/// True if a formula gives a depth to which the bed is scoured, whatever the time.
inline bool is_depth(const FormulaRow& row) { return row.value && row.unit == "m" && row.gives == "scour depth"; }

struct ReportInput;
/// True if the depth of a formula has room in the picture of the depths over time.
bool is_drawn(const ReportInput& input, const FormulaRow& row);

/// The contents of the page. The page adds nothing that is not here or in the files named here.
struct ReportInput {
  Case resolved;
  RunFolder run;
  ExtractionRun extraction;
  std::vector<ProfileSet> sets;          // the run first
  std::vector<ProfileSet> line_sources;  // what was measured along lines and not along x: places, without profiles
  Comparison comparison;
  std::vector<std::string> reference_notes;  // empty slots and the like, in words
  std::vector<Repeatability> repeatability;
  std::vector<std::string> repeatability_origin;  // what its file says of where the numbers come from
  History history;
  std::vector<Timing> timing;
  std::vector<Quantity> summary;
  Computed computed;
  std::vector<MeshModel> meshes;
  std::vector<Method> methods;
  std::vector<std::string> compare_arguments;
  std::string shortfall;  // a sentence on a run that has not reached its end; empty for others
  std::vector<std::string> warnings;
  BedHistory bed_history;
  OpeningRecords openings;
  ScourRecord scour;
  ScourSeries series;                 // of the whole bed; empty without one
  std::optional<ScourAnswer> answer;  // nothing without a bed
  ScourBand band;
  RunBedMap map;
  ReportUnits units;
  std::vector<ScourCheck> scour_checks;
  std::vector<FormulaRow> formulas;  // of scour, that the case gives the inputs of
  std::vector<VelocityStation> stations;
  bool in_space = false;  // with the 3-D view
};

/// Writes report/pictures (gnuplot scripts and what they draw), report/data (the curves as drawn) and
/// report/index.html, a page that needs no other file and no network. Returns false when pictures are missing; the page
/// then says so. Names what it has to leave out in the warnings. Throws RunError.
bool write_report(ReportInput& input);

}  // namespace thalweg
