#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/error.hpp"

namespace thalweg {

struct PostprocessOptions {
  std::filesystem::path folder;        // of the run
  std::vector<std::string> compare;    // further sources, "PATH" or "LABEL=PATH"
  bool report = false;                 // pictures and index.html
  std::vector<std::string> lines{};    // further lines for profiles, "NAME=0 m,0.1 m,1 m,0.1 m"
  bool surfaces = true;                // surfaces as .vtp and .stl
  std::vector<std::string> repeats{};  // folders of runs that should give the same
};

/// Surfaces, profiles, series, comparison and, if asked for, the report of a run. Returns Exit::run_failed, after doing
/// all that can be done, when a snapshot is damaged or missing or the pictures cannot be drawn; each reason is one line
/// on stderr. Throws InputError when there is nothing to work on, RunError when results cannot be written.
Exit postprocess(const PostprocessOptions& options);

}  // namespace thalweg
