#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/run_folder.hpp"
#include "postproc/comparison.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/method_cost.hpp"
#include "postproc/run_records.hpp"

namespace thalweg {

/// A mesh model beside the run.
struct MeshModel {
  std::string label;
  std::vector<Quantity> summary;
};

/// How far the bed has risen (+) or sunk (-) since the run's first profile, at every place and time there is a profile
/// of.
struct BedHistory {
  std::filesystem::path
      file;               // x [m], time [s], from [s], to [s], change [m]; from and to: half-way to the times beside
  std::size_t times = 0;  // [-] 0: there is no table, for want of a bed or of times
  double largest = 0;     // [m] magnitude
};

/// Everything the page is made of; the page adds nothing that is not here or in the files it names.
struct ReportInput {
  Case resolved;
  RunFolder run;
  ExtractionRun extraction;
  std::vector<ProfileSet> sets;  // the run first
  Comparison comparison;
  std::vector<std::string> reference_notes;  // empty slots and the like, in words
  std::vector<Repeatability> repeatability;
  std::vector<std::string> repeatability_origin;  // what its file says of where the numbers come from
  History history;
  std::vector<Timing> timing;
  std::vector<Quantity> summary;
  std::vector<MeshModel> meshes;
  std::vector<Method> methods;
  std::vector<std::string> compare_arguments;
  std::vector<std::string> warnings;
  BedHistory bed_history;
  bool in_space = false;  // with the 3-D view
};

/// Writes report/pictures (gnuplot scripts and what they draw), report/data (the curves as drawn) and
/// report/index.html, a page that needs no other file and no network. Returns false when the pictures are missing
/// because gnuplot is not installed; the page then says so. Adds to the warnings what it had to leave out. Throws
/// RunError.
bool write_report(ReportInput& input);

}  // namespace thalweg
