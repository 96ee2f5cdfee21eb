#pragma once

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Gives the water of a driven flow the velocity that flow.start names, column by column: the depth is that of the water
/// in one piece around a node, the roughness that of the wall or sediment below it. `particles` are those of the
/// filling, in the order of its nodes. Nothing happens where it starts at rest.
/// Throws InputError if no water lies at the seam of the period of a driven flow: nothing could flow around it.
void start_flow(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                ParticleSet& particles);

}  // namespace thalweg::gencase
