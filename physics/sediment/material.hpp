#pragma once

#include <cmath>

#include "physics/sediment/drucker_prager.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/sediment/mu_of_i.hpp"
#include "physics/sediment/sediment_parameters.hpp"

// The law of a sediment, composed from the laws in this folder:
//
//   parameters of the case, choices  ->  constants  ->  yield stress tau_y  ->  apparent viscosity eta
//
//   tau_y = f(theta) (K p_eff + c_0)
//     K, c_0     of the chosen yield fit                           drucker_prager.hpp
//     f(theta)   1, or Mohr-Coulomb's factor at the Lode angle     mohr_coulomb.hpp
//   eta = Herschel-Bulkley-Papanastasiou's viscosity               herschel_bulkley.hpp
//     or that of mu(I) between K of the friction angle and K of    mu_of_i.hpp
//     the dynamic friction angle, both times f(theta)
//
// The particle model, the mesh model in OpenFOAM and their tests all call these functions. The header must stay C++17:
// OpenFOAM's build compiles it.
namespace thalweg {

/// The laws that a sediment follows.
struct MaterialChoices {
  YieldCriterion yield = YieldCriterion::drucker_prager;
  YieldFit yield_fit = YieldFit::sine;
  Rheology rheology = Rheology::herschel_bulkley;
  bool as_printed = false;  // the paper's (8) taken for the viscosity itself, of which it is twice
};

/// Constants of a sediment's law, SI. Real: float for particles, double for the mesh model.
template <class Real>
struct SedimentMaterial {
  Real yield_coefficient = 0;    // K [-] in plane strain
  Real yield_cohesion = 0;       // c_0 [Pa] in plane strain
  Real friction_tangent = 0;     // tan(phi) [-]
  Real regularisation = 0;       // m [s]
  Real consistency = 0;          // k [Pa s^n]
  Real flow_index = 1;           // n [-]
  Real dynamic_coefficient = 0;  // K [-] of the dynamic friction angle, for mu(I)
  InertialScale<Real> inertia{};
  YieldCriterion yield = YieldCriterion::drucker_prager;
  Rheology rheology = Rheology::herschel_bulkley;
  Real printed_factor = 1;  // of Herschel-Bulkley's viscosity [-]
};

/// The yield fit that decides K and c_0 in plane strain. Mohr-Coulomb's criterion has one strength there,
/// p sin(phi) + c cos(phi), whatever fit is asked for.
inline YieldFit plane_strain_fit(YieldCriterion yield, YieldFit wanted) {
  switch (yield) {
    case YieldCriterion::mohr_coulomb:
      return YieldFit::sine;
    case YieldCriterion::drucker_prager:
      break;
  }
  return wanted;
}

/// Constants of the law from the parameters of a case, computed in double and then rounded to Real.
template <class Real>
SedimentMaterial<Real> make_material(const SedimentParameters& s, const MaterialChoices& choices) {
  const YieldFit fit = plane_strain_fit(choices.yield, choices.yield_fit);
  SedimentMaterial<Real> out;
  out.yield_coefficient = static_cast<Real>(yield_pressure_coefficient(s.friction_angle, fit));
  out.yield_cohesion = static_cast<Real>(yield_cohesion_term(s.cohesion, s.friction_angle, fit));
  out.friction_tangent = static_cast<Real>(std::tan(s.friction_angle));
  out.regularisation = static_cast<Real>(s.regularisation);
  out.consistency = static_cast<Real>(s.consistency);
  out.flow_index = static_cast<Real>(s.flow_index);
  out.dynamic_coefficient = static_cast<Real>(yield_pressure_coefficient(s.dynamic_friction_angle, fit));
  out.inertia = {static_cast<Real>(s.inertial_number), static_cast<Real>(s.grain_diameter),
                 static_cast<Real>(s.grain_density)};
  out.yield = choices.yield;
  out.rheology = choices.rheology;
  out.printed_factor = choices.as_printed ? 2 : 1;
  return out;
}

/// Yield stress tau_y [Pa] under an effective pressure [Pa] >= 0. lode_sine: sine of three Lode angles of the rate of
/// strain [-], in [-1, 1]; Drucker-Prager's cones do not depend on it.
template <class Real>
HOST_DEVICE inline Real yield_stress_of(const SedimentMaterial<Real>& of, Real effective_pressure, Real lode_sine) {
  const Real in_plane_strain = of.yield_coefficient * effective_pressure + of.yield_cohesion;
  switch (of.yield) {
    case YieldCriterion::mohr_coulomb:
      return mohr_coulomb_factor(lode_sine, of.yield_coefficient) * in_plane_strain;
    case YieldCriterion::drucker_prager:
      break;
  }
  return in_plane_strain;
}

/// Apparent viscosity eta [Pa s] at the shear rate sqrt(2 D:D) [1/s]. yield_stress [Pa] is the particle's own, as
/// yield_stress_of() gives it unless something else decides it; effective_pressure [Pa] and lode_sine [-] as there.
template <class Real>
HOST_DEVICE inline Real apparent_viscosity_of(const SedimentMaterial<Real>& of, Real shear_rate, Real yield_stress,
                                              Real effective_pressure, Real lode_sine) {
  switch (of.rheology) {
    case Rheology::herschel_bulkley:
      return of.printed_factor *
             herschel_bulkley_viscosity(shear_rate, yield_stress, of.regularisation, of.consistency, of.flow_index);
    case Rheology::mu_of_i:
      break;
  }
  Real mu_s = of.yield_coefficient;
  Real mu_2 = of.dynamic_coefficient;
  switch (of.yield) {
    case YieldCriterion::mohr_coulomb:
      mu_s *= mohr_coulomb_factor(lode_sine, mu_s);
      mu_2 *= mohr_coulomb_factor(lode_sine, mu_2);
      break;
    case YieldCriterion::drucker_prager:
      break;
  }
  return mu_of_i_viscosity(shear_rate, yield_stress, effective_pressure, mu_2 - mu_s, of.regularisation, of.consistency,
                           of.inertia);
}

}  // namespace thalweg
