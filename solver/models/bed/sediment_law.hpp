#pragma once

#include "solver/state/particles.hpp"

// Strength and viscosity of a sediment particle by the laws its scene has chosen.
namespace thalweg {

/// Yield stress K p_eff + c_0 [Pa].
HOST_DEVICE inline float yield_stress_of(const SedimentScene& law, const Sediment& s) {
  const float in_plane_strain = law.yield_coefficient * s.effective_pressure + law.yield_cohesion;
  if (law.yield == YieldCriterion::drucker_prager) return in_plane_strain;
  return mohr_coulomb_factor(s.lode_sine, law.yield_coefficient) * in_plane_strain;
}

/// Apparent viscosity [Pa s]; the particle's yield stress is known.
HOST_DEVICE inline float apparent_viscosity_of(const SedimentScene& law, const Sediment& s) {
  if (law.rheology == Rheology::herschel_bulkley) {
    return herschel_bulkley_viscosity(s.strain_rate, s.yield_stress, law.regularisation, law.consistency,
                                      law.flow_index);
  }
  float mu_s = law.yield_coefficient;
  float mu_2 = law.dynamic_coefficient;
  if (law.yield == YieldCriterion::mohr_coulomb) {
    mu_s *= mohr_coulomb_factor(s.lode_sine, mu_s);
    mu_2 *= mohr_coulomb_factor(s.lode_sine, mu_2);
  }
  return mu_of_i_viscosity(s.strain_rate, s.yield_stress, s.effective_pressure, mu_2 - mu_s, law.regularisation,
                           law.consistency, law.inertia);
}

}  // namespace thalweg
