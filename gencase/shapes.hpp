#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "gencase/flow_room.hpp"
#include "gencase/region.hpp"
#include "gencase/surface_shapes.hpp"

namespace thalweg::gencase {

/// A shape with a role in the filling, and its geometry.
struct PlacedShape {
  const Shape* shape = nullptr;
  RegionPointer body;           // a volume of fluid, a solid with its core, or the wall of a container
  RegionPointer room;           // containers: their inside, extended through open faces; nullptr for other shapes
  double thickness = 0;         // [m] walls: depth below the skin up to which there are particles
  double density_at_rest = 0;   // [kg/m^3] of its particles
  double weighing_density = 0;  // [kg/m^3] the same with the grains that water carries

  [[nodiscard]] bool is_fluid() const { return shape->role == ShapeRole::water || shape->role == ShapeRole::sediment; }
  [[nodiscard]] bool is_wall() const { return shape->role == ShapeRole::wall || shape->role == ShapeRole::moving_wall; }
  [[nodiscard]] bool is_container() const { return room != nullptr; }
  [[nodiscard]] bool is_moving() const { return shape->role == ShapeRole::moving_wall; }
  /// True if it does not replace an earlier shape: fluids do not replace walls, and moving walls do not replace fixed
  /// ones, which would have a hole when they have moved.
  [[nodiscard]] bool yields_to(const PlacedShape& earlier) const {
    return earlier.is_wall() && (is_fluid() || (is_moving() && !earlier.is_moving()));
  }
  /// Type of its particles; only for fluids and walls.
  [[nodiscard]] ParticleType type() const;
};

/// Radius of the kernel's support, 2 h [m].
double kernel_support(const Case& scene);

/// Axis (0, 1 or 2) of the largest component of gravity; 2 without gravity.
int column_axis(const Case& scene);

/// The geometry of every shape with a role, in the order of the case. Throws InputError naming shape, line, cause and
/// cure: a shape thinner than the spacing, a container that walls off a periodic direction, a mesh that bounds no
/// volume (surface_shapes.hpp). `scene` must outlive the result.
std::vector<PlacedShape> place_shapes(const Case& scene, const Notes& notes = {});

/// The space that the walls among `shapes` leave to the flow at t = 0.
FlowRoom flow_room(const std::vector<PlacedShape>& shapes);
/// The space that the walls of one motion alone leave to the flow; "": the fixed walls alone.
FlowRoom flow_room(const std::vector<PlacedShape>& shapes, const std::string& motion);

}  // namespace thalweg::gencase
