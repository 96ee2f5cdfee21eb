#pragma once

#include <filesystem>
#include <string>

#include "foam_reference/case_files.hpp"

// The case's gauges on a mesh: OpenFOAM records cells beside them while it runs, and gauges.csv is made of these.
namespace thalweg::foam {

/// Entries of controlDict's functions that record what the gauges need, at each step that ends an interval of
/// output.gauge_interval; empty without gauges.
std::string gauge_functions(const FoamCase& foam_case);

/// Writes gauges.csv into `folder` with the columns of the particles' gauges.csv, if the case has gauges: pressure and
/// velocity, linear between the cells; water level and bed as column integrals (column_sampler.hpp). The column of a flux
/// is empty: nothing records it. A place in a solid has empty entries, and a note.
void write_gauges(const FoamCase& foam_case, const std::filesystem::path& folder);

}  // namespace thalweg::foam
