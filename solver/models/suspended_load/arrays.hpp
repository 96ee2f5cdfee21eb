#pragma once

#include <cstdint>

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field grains{"Grains"};
inline constexpr Field suspended{"Suspended"};
inline constexpr Field receiver{"Receiver"};
inline constexpr Field own_id{"OwnId"};
/// Meanings of the work quad, of water: concentration [-] and diffusivity [m^2/s] of its grains, in the first two
/// directions of the scene; viscosity that the grains add [Pa s].
inline constexpr Field load_of_water{"LoadOfWater", quad_work};
inline constexpr Field added_viscosity{"AddedViscosity", quad_work};
}  // namespace field

/// The receiver of particles that give no grains away: the id of none.
inline constexpr std::int64_t no_particle = -1;

/// The diffusivity of water in the zone of an inlet or outlet: its grains go along with it, and nothing else happens to
/// them. Where they sank, a quarter of them lay on the floor of an outlet's zone before they were counted as gone.
inline constexpr float of_opening = -1;

/// Numbers that follow from the grains of a particle and what is around it.
struct Suspended {
  float
      concentration;  // of water: volume share of grains [-]; of a bed particle: its grains over those of a packed one
  float diffusivity;  // of water: of its grains [m^2/s], or of_opening
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
  /// Over a bed of particles: the id of each particle of the fluid, and of those that give grains away the id of the water
  /// that gets them and becomes a particle of the bed.
  typename Device::template Buffer<std::int64_t> own_id;
  typename Device::template Buffer<std::int64_t> receiver;

  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    const bool bed_of_particles = !scene.surface_bed.on;
    v.array(field::grains, grains, bed_of_particles ? sorted | checkpointed | halo : sorted | checkpointed, 0.0);
    if (bed_of_particles) {
      v.array(field::own_id, own_id, halo, no_particle);
      v.array(field::receiver, receiver, halo, no_particle);
    }
    v.array(field::suspended, suspended, sorted | checkpointed | halo, Suspended{});
    v.shown("Concentration", suspended, &Suspended::concentration, {.fluid_only = true});
  }
};

}  // namespace thalweg
