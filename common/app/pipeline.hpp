#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace thalweg {

/// Options of `thalweg run`.
struct PipelineOptions {
  std::filesystem::path case_path;
  std::filesystem::path out;            // empty: out/<case name>
  std::vector<std::string> overrides;   // "table.key=value"
  std::vector<std::string> for_solver;  // arguments passed on to it
  bool foam = true;                     // also the mesh model
  bool resume = false;                  // goes on with the run in the folder
  bool force = false;                   // replaces the run in the folder
};

/// Runs gencase, solver, foam and postproc one after the other, with a line on each. Returns 0, or the exit status of
/// the first stage that fails. If foam fails, the report is made without it before its status is returned. Throws InputError if the case is wrong, or if the folder holds a run and neither `resume`
/// nor `force` is set.
int run_pipeline(const PipelineOptions& options);

}  // namespace thalweg
