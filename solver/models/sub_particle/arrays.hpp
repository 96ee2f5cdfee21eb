#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// Parameters of the sub-particle stress.
template <int Dim>
struct SubParticleScene {
  bool sub_particle_stress = false;
};

namespace field {
inline constexpr Field sub_particle{"SubParticle"};
/// Meanings of the work quad: the stress times density [Pa]. A lane carries as many numbers of the quad as the scene has
/// dimensions, so that the tensor takes two turns: xx, (yy,) zz, then xz or xy, xz, yz.
inline constexpr Field stress_diagonal{"StressDiagonal", quad_work};
inline constexpr Field stress_off_diagonal{"StressOffDiagonal", quad_work};
}  // namespace field

/// Part of a particle's sub-particle stress; zero of all but water.
struct SubParticle {
  float off_diagonal[3];  // [Pa] xz in the plane; xy, xz, yz in space
  float eddy_viscosity;   // [m^2/s]
};

/// Arrays of the sub-particle stress; empty without it.
template <class Device>
struct SubParticleArrays {
  typename Device::template Buffer<SubParticle> sub_particle;

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::sub_particle, sub_particle, sorted, SubParticle{});
    v.shown("EddyViscosity", sub_particle, &SubParticle::eddy_viscosity);
  }
};

}  // namespace thalweg
