#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field pore_pressure{"ExcessPorePressure"};
inline constexpr Field solids{"ShareOfSolids"};
}  // namespace field

/// Arrays of the excess pore pressure; empty without it.
template <class Device>
struct PorePressureArrays {
  typename Device::template Buffer<float> excess_pore_pressure;  // [Pa] of sediment, 0 of other particles
  typename Device::template Buffer<float> solids;                // share of solids [-]; empty without dilatancy

  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    if (scene.pores.critical_solids > 0) {
      v.array(field::solids, solids, sorted | checkpointed, scene.pores.solids_at_start);
      v.shown("ShareOfSolids", solids);
    }
    v.array(field::pore_pressure, excess_pore_pressure, sorted | checkpointed, 0.0F);
    v.shown("ExcessPorePressure", excess_pore_pressure);
  }
};

}  // namespace thalweg
