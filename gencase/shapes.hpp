#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "gencase/flow_room.hpp"
#include "gencase/region.hpp"
#include "gencase/surface_shapes.hpp"

namespace thalweg::gencase {

/// A shape that puts particles somewhere or takes them away.
struct PlacedShape {
  const Shape* shape = nullptr;
  RegionPointer body;          // what it claims: a volume of fluid, a solid with its core, the layers of a container
  RegionPointer room;          // containers: their inside, continued through open faces
  double thickness = 0;        // [m] walls: how deep below their skin particles stand
  double density_at_rest = 0;  // [kg/m^3] of its particles

  [[nodiscard]] bool is_fluid() const { return shape->role == ShapeRole::water || shape->role == ShapeRole::sediment; }
  [[nodiscard]] bool is_wall() const { return shape->role == ShapeRole::wall || shape->role == ShapeRole::moving_wall; }
  [[nodiscard]] bool is_container() const { return room != nullptr; }
  [[nodiscard]] bool is_moving() const { return shape->role == ShapeRole::moving_wall; }
  /// Whether it leaves what an earlier shape has to it: fluids every wall, walls that move what stands still and would
  /// be a hole when they are gone.
  [[nodiscard]] bool yields_to(const PlacedShape& earlier) const {
    return earlier.is_wall() && (is_fluid() || (is_moving() && !earlier.is_moving()));
  }
  /// What its particles are; only for fluids and walls.
  [[nodiscard]] ParticleType type() const;
};

/// Reach of the kernel, 2 h [m].
double kernel_support(const Case& scene);

/// Direction in which gravity pulls most: 0, 1 or 2; the last direction without gravity.
int column_axis(const Case& scene);

/// The geometry of every shape with a role, in the order of the case. Throws InputError naming shape, line, cause and
/// cure: a shape thinner than the spacing, a container that walls off a periodic direction, a mesh that bounds no
/// volume (surface_shapes.hpp). `scene` must outlive the result.
std::vector<PlacedShape> place_shapes(const Case& scene, const Notes& notes = {});

/// The room the walls among `shapes` leave to the flow at t = 0.
FlowRoom flow_room(const std::vector<PlacedShape>& shapes);
/// The room that only those walls leave which move as the motion of this name says; "": which stand still.
FlowRoom flow_room(const std::vector<PlacedShape>& shapes, const std::string& motion);

}  // namespace thalweg::gencase
