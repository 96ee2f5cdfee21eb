#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/error.hpp"

namespace thalweg {

struct PostprocessOptions {
  std::filesystem::path folder;                 // of the run
  std::vector<std::string> compare;             // further sources, "PATH" or "LABEL=PATH"
  bool report = false;                          // pictures and index.html
  bool in_space = false;                        // the report with a 3-D view
  bool movie = false;                           // a frame of each snapshot, and a film
  bool paper_figures = false;                   // the source paper's figures from this run and from `series`
  std::vector<std::filesystem::path> series{};  // runs of one case at several spacings
  std::vector<std::string> lines{};             // further lines for profiles, "NAME=0 m,0.1 m,1 m,0.1 m"
  bool surfaces = true;                         // surfaces as .vtp and .stl
  std::vector<std::string> repeats{};           // folders of further runs of the same case
  std::filesystem::path bed_survey{};           // file for the last bed as a survey; empty: none
};

/// Surfaces, profiles, series, comparison and, if asked for, the report of a run. Returns Exit::run_failed, after doing
/// all that can be done, when a snapshot is damaged or missing or the pictures cannot be drawn; each reason is one line
/// on stderr. Throws InputError if there is no run or no snapshot to work on, RunError if results cannot be written.
Exit postprocess(const PostprocessOptions& options);

}  // namespace thalweg
