#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/field.hpp"

namespace thalweg {

namespace field {
inline constexpr Field eddies{"Eddies"};
}

/// The eddies around a particle of water; means nothing of others.
struct Eddies {
  float wall_distance;  // to the nearest wall or bed [m]; 0 where none can be reached through the water
  float depth;          // of the water [m]
  float viscosity;      // kinematic, of the eddies alone [m^2/s]
};

/// Arrays of the eddy viscosity by mixing length; empty without it.
template <class Device>
struct MixingLengthArrays {
  typename Device::template Buffer<Eddies> eddies;

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::eddies, eddies, sorted | checkpointed, Eddies{});
    v.shown("EddyViscosity", eddies, &Eddies::viscosity);
  }
};

}  // namespace thalweg
