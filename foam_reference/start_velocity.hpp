#pragma once

#include <string>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// The regions of system/setFieldsDict that start the water as flow.start says, with the particle model's profile over the
/// ground of each column of cells, and with k and omega of that profile where the case has them. Empty for water that
/// starts at rest.
std::string start_regions(const FoamCase& foam_case);

}  // namespace thalweg::foam
