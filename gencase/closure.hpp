#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// A way by which fluid at rest could leave its room, from lattice node to lattice node.
struct Leak {
  std::vector<Vec3> path;     // [m] from a fluid particle to the outside
  bool out_of_rooms = false;  // ends outside of every container; else at the edge of the domain
};

/// Floods the free nodes from the fluid, from node to next node and no higher than the fluid's highest particle, and
/// says whether the flood leaves the containers or reaches the edge of the domain. Open faces of containers and
/// periodic directions are no leak. A leak narrower than the spacing is none: no particle passes it.
std::optional<Leak> find_leak(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                              const Filling& filling);

}  // namespace thalweg::gencase
