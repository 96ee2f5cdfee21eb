#pragma once

#include "gencase/filling.hpp"
#include "gencase/notes.hpp"

namespace thalweg::gencase {

/// Clears the nodes of fluids in the zones of inlets, which the solver fills with particles of its own, the highest row of
/// the ground under a zone that brings bed load, and the nodes of water beyond the zones of outlets' levels. Says how many.
/// Throws InputError for an opening that walls close, for zones that overlap, for water that stands behind the zone of an
/// outlet, for sediment past a plane, and for bed load that finds no ground or no bed.
void clear_openings(const Case& scene, const std::vector<PlacedShape>& shapes, Filling& filling, const Notes& notes);

}  // namespace thalweg::gencase
