#pragma once

#include "physics/sediment/herschel_bulkley.hpp"

namespace thalweg {

/// The law by which yielded sediment flows.
enum class Rheology { herschel_bulkley, mu_of_i };

/// Inertial number I = gdot d sqrt(rho_s/p) [-]: the time that a grain takes to fall into its gap, over the time of
/// shear. Shear rate gdot [1/s], grain diameter d [m], grain density rho_s [kg/m^3], effective pressure p > 0 [Pa].
template <class Real>
HOST_DEVICE inline Real inertial_number(Real gdot, Real diameter, Real grain_density, Real pressure) {
  using std::sqrt;
  return gdot * diameter * sqrt(grain_density / pressure);
}

/// Friction coefficient of a dense granular flow [-] (Jop, Forterre & Pouliquen 2006, Nature 441, 727-730):
///   mu(I) = mu_s + (mu_2 - mu_s)/(1 + I0/I)
/// mu_s at I = 0, mu_2 at I -> infinity, half-way between the two at I0 = half_way [-].
/// Glass beads: mu_s = 0.38, mu_2 = 0.64, I0 = 0.279, hence mu(I0) = 0.51.
template <class Real>
HOST_DEVICE inline Real friction_of_inertial_number(Real I, Real mu_s, Real mu_2, Real half_way) {
  return mu_s + (mu_2 - mu_s) * I / (half_way + I);
}

/// Constants of the inertial number.
template <class Real>
struct InertialScale {
  Real inertial_number = Real(0.279);  // I0 [-]
  Real diameter = 0;                   // d [m]
  Real grain_density = 0;              // rho_s [kg/m^3]
};

/// Apparent viscosity [Pa s] of a granular flow at the shear rate gdot = sqrt(2 D:D) [1/s] under the effective pressure
/// p [Pa]:
///   eta = (mu(I) p + c_0)/gdot = tau_y/gdot + (mu_2 - mu_s) p T/(I0 + gdot T)
///   tau_y = mu_s p + c_0,   T = d sqrt(rho_s/p)
/// The first part, the yield stress over gdot, is regularised as Papanastasiou's (herschel_bulkley.hpp) with m [s]. The
/// second part, by which friction grows with the rate, is finite at rest and vanishes with p. It is coded with
/// p T = d sqrt(rho_s p) as
///   (mu_2 - mu_s) d sqrt(rho_s) p/(I0 sqrt(p) + gdot d sqrt(rho_s))
/// where sqrt(p) in the denominator is kept above that of 1e-3 Pa, a thousandth of the weight of a layer of small
/// grains, so that p = gdot = 0 gives 0. The viscosity of the fluid between the grains [Pa s] is added.
/// friction_growth = mu_2 - mu_s [-]; yield_stress tau_y [Pa]; regularisation m [s].
/// Limits of eta gdot: mu(I) p + c_0 far above yield; mu_2 p + c_0 for I -> infinity.
/// Limit of eta for gdot -> 0: tau_y m/2 + (mu_2 - mu_s) d sqrt(rho_s p)/I0.
/// mu_s = 0.38, mu_2 = 0.64, I0 = 0.279, d = 1 mm, 2500 kg/m^3, p = 100 Pa, gdot = 50 1/s (I = 0.25): 1.006 Pa s.
template <class Real>
HOST_DEVICE inline Real mu_of_i_viscosity(Real gdot, Real yield_stress, Real pressure, Real friction_growth,
                                          Real regularisation, Real pore_viscosity, const InertialScale<Real>& of) {
  using std::sqrt;
  constexpr Real pressure_floor = Real(1e-3);
  const Real p = pressure > 0 ? pressure : Real(0);
  const Real inertia = of.diameter * sqrt(of.grain_density);
  const Real root_p = sqrt(p > pressure_floor ? p : pressure_floor);
  const Real growing = friction_growth * inertia * p / (of.inertial_number * root_p + gdot * inertia);
  return herschel_bulkley_viscosity(gdot, yield_stress, regularisation, pore_viscosity, Real(1)) + growing;
}

}  // namespace thalweg
