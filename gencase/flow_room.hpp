#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Where there is no wall and fluid may be: inside the containers and openings (everywhere if there are none) and
/// outside everything solid. Its skin is what walls turn towards the flow; what the walls hide from it (the foot of a
/// pier sunk into the floor) is no skin.
class FlowRoom : public PointSet {
 public:
  /// A container's inside.
  void add_room(RegionPointer room);
  /// A wall; it takes the place of earlier openings.
  void add_solid(RegionPointer solid);
  /// What an "empty" shape opens in earlier walls.
  void add_opening(RegionPointer opening);

  [[nodiscard]] bool contains(const Vec3& point) const override;
  void append_surfaces(std::vector<const Surface*>& surfaces) const override;
  /// Whether `point` lies inside a container or opening, or there is no container at all.
  [[nodiscard]] bool inside_rooms(const Vec3& point) const;

 private:
  struct Layer {
    RegionPointer region;
    bool solid;
  };
  std::vector<RegionPointer> rooms_;
  std::vector<Layer> layers_;  // in the order of the case
};

}  // namespace thalweg::gencase
