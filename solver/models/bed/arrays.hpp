#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field sediment{"SedimentState"};
}

/// The state of a particle in a scene with sediment, beside its record.
struct Sediment {
  float strain_rate;              // gdot = sqrt(2 D:D) [1/s]
  float lode_sine;                // of three Lode angles of the rate of strain [-]; 0 in the plane
  float effective_pressure;       // [Pa]
  float yield_stress;             // [Pa]
  float bed_slope;                // tangent of the slope of the bed's surface above or below [-]
  float time_below_yield;         // for how long it has been below yield and slow [s] (models/rest)
  float viscous_acceleration[3];  // of the last implicit solve [m/s^2], where the next one starts
};

/// Arrays of the bed model; empty without sediment.
template <class Device>
struct BedArrays {
  typename Device::template Buffer<Sediment> sediment;

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::sediment, sediment, sorted | checkpointed | halo, Sediment{});
    v.shown("StrainRate", sediment, &Sediment::strain_rate);
    v.shown("EffectivePressure", sediment, &Sediment::effective_pressure);
    v.shown("YieldStress", sediment, &Sediment::yield_stress);
  }
};

}  // namespace thalweg
