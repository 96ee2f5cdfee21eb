#pragma once

#include <vector>

#include "common/profile.hpp"

namespace thalweg {

/// Rise (+) or fall (-) of the bed between two profiles at the columns of `after` [m]. NaN where the first has no such
/// column, where no sediment lies before and after, and where the walls below differ: a deck, a piston. Profiles without
/// a floor are compared as they are.
std::vector<double> rise_of_bed(const Profile& before, const Profile& after);

}  // namespace thalweg
