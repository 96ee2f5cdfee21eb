#pragma once

#include "gencase/flow_room.hpp"
#include "gencase/notes.hpp"

namespace thalweg::gencase {

/// Makes the search for the nearest point of the flow's skin. With a mesh among the walls of a 3-D scene it uses one
/// closed surface, cut out of all walls with exact arithmetic. Without meshes, or if that surface cannot be made, it
/// searches the surfaces one by one (nearest_surface.hpp). `around` must contain every wall particle and all skin that
/// may be the nearest to it. `room` must outlive the result.
std::unique_ptr<SkinSearch> make_flow_skin(const FlowRoom& room, const Bounds& around, double spacing, int dimension,
                                           const Notes& notes);

}  // namespace thalweg::gencase
