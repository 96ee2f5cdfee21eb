#pragma once

#include "gencase/filling.hpp"
#include "gencase/notes.hpp"

namespace thalweg::gencase {

/// Clears the nodes of fluids in the zones of inlets, which the solver fills with particles of its own, and those of water
/// beyond the zones of outlets' levels. Says how many. Throws InputError for an opening that walls close, for zones that
/// overlap, for water that stands behind the zone of an outlet, and for sediment past a plane.
void clear_openings(const Case& scene, const std::vector<PlacedShape>& shapes, Filling& filling, const Notes& notes);

}  // namespace thalweg::gencase
