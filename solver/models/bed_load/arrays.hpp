#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field drift{"Drift"};
/// The work quad before the viscous solve: of sediment, Drift::drag.
inline constexpr Field drag_of_bed{"DragOfBed", quad_work};
}  // namespace field

/// Drift and drag of a particle of sediment at the water; 0 of others.
struct Drift {
  float velocity[3];  // over the skeleton [m/s]
  float drag;         // K/S, coefficient of the water's drag over the share of water in reach [kg/(m^dim s)]
};

/// Arrays of the model of bed load; empty without it.
template <class Device>
struct BedLoadArrays {
  typename Device::template Buffer<Drift> drift;

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::drift, drift, sorted | checkpointed | halo, Drift{});
  }
};

}  // namespace thalweg
