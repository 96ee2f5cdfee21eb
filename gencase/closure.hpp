#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// A path from lattice node to lattice node on which fluid at rest could leave the containers.
struct Leak {
  std::vector<Vec3> path;     // [m] from a fluid particle to the outside
  bool out_of_rooms = false;  // true: it ends outside of every container; false: at the edge of the domain
};

/// Searches for a leak: floods the free nodes from the fluid, from each node to its direct neighbours and no higher
/// than the fluid's highest particle, until the flood leaves the containers or reaches the edge of the domain. Open
/// faces of containers and periodic directions are no leaks. Gaps narrower than the spacing are not found: no particle
/// passes them. Returns nothing if there is no leak.
std::optional<Leak> find_leak(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                              const Filling& filling);

}  // namespace thalweg::gencase
