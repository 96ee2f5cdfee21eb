#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The space in which fluid may be: inside the containers and openings (everywhere if there are none) and outside of
/// everything solid. Its skin is the part of the walls that faces the flow. Wall surfaces that other walls cover, such
/// as the foot of a pier sunk into the floor, are no part of it.
class FlowRoom : public PointSet {
 public:
  /// Adds a container: its inside and its wall. The wall closes earlier openings in its place.
  void add_container(RegionPointer room, RegionPointer wall);
  /// Adds a solid. It closes earlier openings in its place.
  void add_solid(RegionPointer solid);
  /// Adds an opening that an "empty" shape makes in earlier walls.
  void add_opening(RegionPointer opening);

  [[nodiscard]] bool contains(const Vec3& point) const override;
  void append_surfaces(std::vector<const Surface*>& surfaces) const override;
  /// True if `point` lies inside a container or opening, or if there is no container.
  [[nodiscard]] bool inside_rooms(const Vec3& point) const;
  /// True if `point` lies inside a container or beyond an open face of one.
  [[nodiscard]] bool inside_containers(const Vec3& point) const;
  [[nodiscard]] bool has_rooms() const { return !rooms_.empty(); }
  /// The parts of a line where fluid may be.
  [[nodiscard]] Spans cut(const Line& line) const;
  /// Bounds of all containers. Needs has_rooms().
  [[nodiscard]] Bounds bounds_of_rooms() const;
  [[nodiscard]] bool has_solids() const;
  /// Bounds of all solids. Needs has_solids().
  [[nodiscard]] Bounds bounds_of_solids() const;
  /// True if a wall is given by triangles.
  [[nodiscard]] bool has_meshes() const;
  /// The skin of the room within `around` as triangles that deviate from it by at most `deviation` [m] and face away
  /// from the fluid; nothing if a wall cannot be given as triangles. Throws NoManifold.
  [[nodiscard]] std::optional<Triangles> triangles(const Bounds& around, double deviation) const;
  /// Places on the skin [m], some on every solid mesh: middles of faces with flow `step` [m] before and none behind
  /// them. The triangles of the room must hold them all.
  [[nodiscard]] std::vector<Vec3> skin_samples(double step) const;

 private:
  struct Layer {
    RegionPointer region;
    bool solid;
    RegionPointer room;  // the inside, if the layer is a container's wall
  };
  std::vector<RegionPointer> rooms_;
  std::vector<Layer> layers_;  // in the order of the case
};

}  // namespace thalweg::gencase
