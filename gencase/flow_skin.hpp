#pragma once

#include "gencase/flow_room.hpp"
#include "gencase/notes.hpp"

namespace thalweg::gencase {

/// The search for the nearest point of the flow's skin that suits the room's walls: where a mesh is among them, one
/// closed surface cut out of all walls with exact arithmetic; else, and where that surface does not exist, the surfaces
/// one by one. `around` has to hold every wall particle and what it can see. `room` must outlive the result.
std::unique_ptr<SkinSearch> make_flow_skin(const FlowRoom& room, const Bounds& around, double spacing, int dimension,
                                           const Notes& notes);

}  // namespace thalweg::gencase
