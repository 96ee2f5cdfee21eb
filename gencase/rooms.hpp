#pragma once

#include "gencase/flow_room.hpp"

namespace thalweg::gencase {

/// What of `region` lies in `room`: a bed under a measured surface, say, that is wider than the flume.
RegionPointer make_within(FlowRoom room, RegionPointer region);

/// The room within `box`: containers filled up to a level.
RegionPointer make_filled(FlowRoom room, const Bounds& box);

/// The lowest `thickness` [m] of the room in every column along `axis` within `box`.
RegionPointer make_layer(FlowRoom room, const Bounds& box, double thickness, int axis);

}  // namespace thalweg::gencase
