#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/field.hpp"

namespace thalweg {

/// A wall particle as a piece of the wall's surface. Area 0: the particle lies inside, or is fluid.
struct WallElement {
  float normal[3];  // unit vector into the flow
  float area;       // [m^(dim-1)]
  float depth;      // of the particle below the surface [m]
  float roughness;  // Nikuradse's sand-grain roughness ks [m]
};

/// A normal that turns with its wall.
struct WallNormal {
  float of[3];
};

/// Shear stress of the water on a wall's element [Pa].
struct WallShear {
  float of[3];
};

namespace field {
inline constexpr Field wall_element{"WallElement"};
inline constexpr Field wall_normal{"WallNormal"};
inline constexpr Field wall_shear{"WallShear"};
/// The work quad between the sweep over the elements and the one over the water: of a wall the force on the water over
/// m0 and the wall particle's volume (wall_stress.hpp). Of others it means nothing.
inline constexpr Field wall_traction{"WallTraction", quad_work};
}  // namespace field

/// Arrays of the walls' shear stress.
template <class Device>
struct WallStressArrays {
  typename Device::template Buffer<WallElement> wall_element;  // as at t = 0
  typename Device::template Buffer<WallNormal> wall_normal;    // now; empty unless walls move
  typename Device::template Buffer<WallShear> wall_shear;      // of the last step; empty unless a model asks for it

  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    v.array(field::wall_element, wall_element, sorted | checkpointed | halo, WallElement{});
    if (scene.has_moving_walls) v.array(field::wall_normal, wall_normal, sorted, WallNormal{});
    if (scene.keeps_wall_shear) v.array(field::wall_shear, wall_shear, sorted, WallShear{});
  }
};

}  // namespace thalweg
