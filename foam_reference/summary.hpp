#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "foam_reference/case_files.hpp"
#include "foam_reference/foam_run.hpp"
#include "foam_reference/reference_run.hpp"

namespace thalweg::foam {

/// Unit of volumes in the tables: "m^3/m" in 2-D, "m^3" in 3-D.
std::string volume_unit(const FoamCase& foam_case);

/// Writes summary.csv of a finished run: quantity, value, unit. `cells`: cells of the mesh without solids.
void write_summary(const FoamCase& foam_case, const std::filesystem::path& file, const FoamRun& run, std::size_t cells,
                   const std::vector<VolumeBalance>& balances);

}  // namespace thalweg::foam
