#pragma once

#include "case/case.hpp"
#include "gencase/flow_room.hpp"

namespace thalweg::gencase {

/// The room that solid walls hold up to `level` [m] where there is no container: the hollow of a tank that was drawn with
/// its wall, or of a basin of several bodies. A place belongs to it if nothing that flows from there, below the level, comes
/// round the walls or below them. Columns a spacing apart decide that, so gaps narrower than a spacing are tight.
/// Nothing if the walls of `room` hold nothing. Heights count along z.
RegionPointer make_hollow(const Case& scene, FlowRoom room, double level);

/// The lowest `thickness` [m] of what the walls hold up to their upper end, in every column.
RegionPointer make_hollow_layer(const Case& scene, FlowRoom room, double thickness);

}  // namespace thalweg::gencase
