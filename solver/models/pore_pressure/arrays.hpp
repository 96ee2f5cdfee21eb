#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field pore_pressure{"ExcessPorePressure"};
}

/// Arrays of the excess pore pressure; empty without it.
template <class Device>
struct PorePressureArrays {
  typename Device::template Buffer<float> excess_pore_pressure;  // [Pa] of sediment, 0 of other particles

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::pore_pressure, excess_pore_pressure, sorted | checkpointed, 0.0F);
    v.shown("ExcessPorePressure", excess_pore_pressure);
  }
};

}  // namespace thalweg
