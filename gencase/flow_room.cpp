#include "gencase/flow_room.hpp"

#include <algorithm>

namespace thalweg::gencase {

void FlowRoom::add_room(RegionPointer room) { rooms_.push_back(std::move(room)); }
void FlowRoom::add_solid(RegionPointer solid) { layers_.push_back({std::move(solid), true}); }
void FlowRoom::add_opening(RegionPointer opening) { layers_.push_back({std::move(opening), false}); }

bool FlowRoom::inside_rooms(const Vec3& point) const {
  const auto holds = [&](const RegionPointer& room) { return room->contains(point); };
  if (rooms_.empty() || std::any_of(rooms_.begin(), rooms_.end(), holds)) return true;
  return std::any_of(layers_.begin(), layers_.end(),
                     [&](const Layer& layer) { return !layer.solid && layer.region->contains(point); });
}

bool FlowRoom::contains(const Vec3& point) const {
  if (!inside_rooms(point)) return false;
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer)
    if (layer->region->contains(point)) return !layer->solid;
  return true;
}

void FlowRoom::append_surfaces(std::vector<const Surface*>& surfaces) const {
  for (const Layer& layer : layers_) layer.region->append_surfaces(surfaces);
}

}  // namespace thalweg::gencase
