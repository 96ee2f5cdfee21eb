#pragma once

#include "gencase/flow_room.hpp"

namespace thalweg::gencase {

/// The part of `region` that lies in `room`; for example of a bed under a measured surface that is wider than the
/// flume.
RegionPointer make_within(FlowRoom room, RegionPointer region);

/// The part of the room within `box`: containers filled up to a level.
RegionPointer make_filled(FlowRoom room, const Bounds& box);

/// The lowest `thickness` [m] of the room in every column along `axis` within `box`.
RegionPointer make_layer(FlowRoom room, const Bounds& box, double thickness, int axis);

}  // namespace thalweg::gencase
