#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "postproc/report.hpp"

namespace thalweg {

/// The label of the run among the sources.
inline constexpr const char* run_label = "Thalweg SPH";

/// Adds the finest mesh model of each kind in foam/ to the sources. Throws InputError.
void add_mesh_models(ReportInput& input);

/// Adds the measured profiles of the case to the sources, or a note on each place that has none. Throws InputError.
void add_measurements(ReportInput& input);

/// Compares the sources along x and along all lines, with the scatter of equal runs: as measured for the case, or of the
/// runs in the folders `repeats`. Throws InputError.
void compare_sources(ReportInput& input, const std::vector<ProfileLine>& further_lines,
                     const std::vector<std::string>& repeats);

}  // namespace thalweg
