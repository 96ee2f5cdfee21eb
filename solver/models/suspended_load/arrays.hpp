#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field grains{"Grains"};
inline constexpr Field suspended{"Suspended"};
inline constexpr Field receiver{"Receiver"};
/// Meanings of the work quad, of water: concentration [-] and diffusivity [m^2/s] of its grains, in the first two
/// directions of the scene; viscosity that the grains add [Pa s].
inline constexpr Field load_of_water{"LoadOfWater", quad_work};
inline constexpr Field added_viscosity{"AddedViscosity", quad_work};
}  // namespace field

/// Numbers that follow from the grains of a particle and what is around it.
struct Suspended {
  float
      concentration;  // of water: volume share of grains [-]; of a bed particle: its grains over those of a packed one
  float diffusivity;  // of water: of its grains [m^2/s]
  float reference;    // of a bed particle: concentration at the reference level [-]
  float friction;     // of a bed particle: friction velocity over it [m/s]
  float exposed;      // of a bed particle: area at the water over the share of water in reach [m^(dim-1)]; 0: none
};

/// Arrays of the suspended load; empty without it.
template <class Device>
struct SuspendedLoadArrays {
  /// Volume of grains [m^dim] that water carries; of a bed particle, that it has more than a packed one.
  typename Device::template Buffer<double> grains;
  typename Device::template Buffer<Suspended> suspended;
  typename Device::template Buffer<Index> receiver;  // where grains go that make a new particle of the bed

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::grains, grains, sorted | checkpointed, 0.0);
    v.array(field::suspended, suspended, sorted | checkpointed | halo, Suspended{});
    v.shown("Concentration", suspended, &Suspended::concentration, {.fluid_only = true});
  }
};

}  // namespace thalweg
