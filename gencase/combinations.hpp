#pragma once

#include "gencase/booleans.hpp"
#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The points that at least one of the parts contains.
RegionPointer make_union(std::vector<RegionPointer> parts);

/// The points that the first part contains and no other part does.
RegionPointer make_difference(std::vector<RegionPointer> parts);

/// The points that all of the parts contain.
RegionPointer make_intersection(std::vector<RegionPointer> parts);

/// One of the three above.
RegionPointer make_combination(std::vector<RegionPointer> parts, Boolean how);

/// The wall of a container of any form: the points outside of `inside` within `thickness` [m] of its skin.
RegionPointer make_shell(RegionPointer inside, double thickness, int dimension);

}  // namespace thalweg::gencase
