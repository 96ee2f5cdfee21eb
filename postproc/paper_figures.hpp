#pragma once

#include <filesystem>
#include <vector>

#include "postproc/report.hpp"

namespace thalweg {

/// The figures of Zhang, Xiong & Liu (2024), made from our runs, the mesh model in the place of their commercial code:
/// front against spacing over an immobile bed (6), start and profiles with their RMSE (8-10), sections inside the tank,
/// at the deepest scour and at the front with local errors (11, 12), deepest scour against time (13). A missing
/// part, a measurement above all, has an empty slot that says what would fill it.
///
/// Writes report/paper: pictures and their scripts, data/*.csv, and index.html, which needs no other file. `series`:
/// runs of one case at several spacings, with their profiles/front.csv. Returns false when pictures are missing, and says
/// why in the warnings of `input`. Throws InputError for a folder that is no run, RunError when nothing can be written.
bool write_paper_figures(ReportInput& input, const std::vector<std::filesystem::path>& series);

}  // namespace thalweg
