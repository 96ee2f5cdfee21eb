#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field bed{"BedSurface"};
}

/// The surface of the sediment around a particle; kept only where sediment has states, zero where no water is
/// in reach (models/states).
struct BedSurface {
  float fill;                  // sum over sediment of V W, 1 inside a bed [-]
  float concentration;         // share of the sediment in the fluid volume within the support [-]
  float normal[3];             // out of the bed, unit
  float water_share;           // sum over water of V W [-]
  float water_velocity[3];     // mean of the water in reach [m/s]
  float water_height;          // of that water over the surface, along the normal [m]
  float log_height;            // at which a logarithmic profile has its mean over that water [m]
  float bed_velocity[3];       // mean of the deposits in reach, 0 without [m/s]
  float settled_share;         // sum over sediment that is not suspended of V W, itself left out [-]
  float shear_stress;          // tau_b [Pa]
  float critical_stress;       // tau_b at which this grain starts to move [Pa]
  float time_below_threshold;  // for how long the grain could have become a deposit again [s]
};

/// Arrays of the model of three states; empty without it.
template <class Device>
struct StatesArrays {
  typename Device::template Buffer<BedSurface> bed;

  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    v.array(field::bed, bed, sorted | checkpointed | halo, BedSurface{});
    v.shown("ShieldsNumber", bed, &BedSurface::shear_stress, {.unit = scene.erosion.grain_weight});
    v.shown("CriticalShieldsNumber", bed, &BedSurface::critical_stress, {.unit = scene.erosion.grain_weight});
  }
};

}  // namespace thalweg
