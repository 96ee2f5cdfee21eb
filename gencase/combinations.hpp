#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// What at least one of the parts contains.
RegionPointer make_union(std::vector<RegionPointer> parts);

/// What the first part contains and no other one does.
RegionPointer make_difference(std::vector<RegionPointer> parts);

/// What all of the parts contain.
RegionPointer make_intersection(std::vector<RegionPointer> parts);

/// The wall of a container of any form: what lies outside of `inside` within `thickness` [m] of its skin.
RegionPointer make_shell(RegionPointer inside, double thickness, int dimension);

}  // namespace thalweg::gencase
