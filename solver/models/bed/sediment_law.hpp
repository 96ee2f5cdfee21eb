#pragma once

#include "physics/sediment/material.hpp"
#include "solver/state/particles.hpp"

// The law of a scene's sediment (physics/sediment/material.hpp) at a particle.
namespace thalweg {

/// Yield stress [Pa].
HOST_DEVICE inline float yield_stress_of(const SedimentScene& law, const Sediment& s) {
  return yield_stress_of(law, s.effective_pressure, s.lode_sine);
}

/// Apparent viscosity [Pa s] at the particle's own yield stress.
HOST_DEVICE inline float apparent_viscosity_of(const SedimentScene& law, const Sediment& s) {
  return apparent_viscosity_of(law, s.strain_rate, s.yield_stress, s.effective_pressure, s.lode_sine);
}

}  // namespace thalweg
