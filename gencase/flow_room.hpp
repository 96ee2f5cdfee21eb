#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Where there is no wall and fluid may be: inside the containers and openings (everywhere if there are none) and
/// outside everything solid. Its skin is what walls turn towards the flow; what the walls hide from it (the foot of a
/// pier sunk into the floor) is no skin.
class FlowRoom : public PointSet {
 public:
  /// A container: its inside and its wall; the wall takes the place of earlier openings.
  void add_container(RegionPointer room, RegionPointer wall);
  /// A solid; it takes the place of earlier openings.
  void add_solid(RegionPointer solid);
  /// What an "empty" shape opens in earlier walls.
  void add_opening(RegionPointer opening);

  [[nodiscard]] bool contains(const Vec3& point) const override;
  void append_surfaces(std::vector<const Surface*>& surfaces) const override;
  /// Whether `point` lies inside a container or opening, or there is no container at all.
  [[nodiscard]] bool inside_rooms(const Vec3& point) const;
  /// Whether `point` lies inside a container, or beyond an open face of one.
  [[nodiscard]] bool inside_containers(const Vec3& point) const;
  [[nodiscard]] bool has_rooms() const { return !rooms_.empty(); }
  /// The parts of a line where fluid may be.
  [[nodiscard]] Spans cut(const Line& line) const;
  /// Around all containers; only where there are some.
  [[nodiscard]] Bounds bounds_of_rooms() const;
  /// Whether a wall is known by its triangles.
  [[nodiscard]] bool has_meshes() const;
  /// The skin of the room within `around` as triangles that leave it by at most `deviation` [m], facing away from the
  /// fluid; nothing if some wall has no triangles. Throws NoManifold.
  [[nodiscard]] std::optional<Triangles> triangles(const Bounds& around, double deviation) const;

 private:
  struct Layer {
    RegionPointer region;
    bool solid;
    RegionPointer room;  // of a container's wall
  };
  std::vector<RegionPointer> rooms_;
  std::vector<Layer> layers_;  // in the order of the case
};

}  // namespace thalweg::gencase
