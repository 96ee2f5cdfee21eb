#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Dilatancy of a sheared packing. A packing that is denser than the one in which it flows steadily opens while it is
// sheared, one that is looser closes. Water has to follow: a dense bed sucks it in and is pressed together, a loose one
// is carried by the water that it presses out.
// Symbols: share of solids phi [-]; rate of strain gdot = sqrt(2 D:D) [1/s]; viscosity of the water eta [Pa s]; pressure
// between the grains p [Pa].
namespace thalweg {

/// Share of solids of a packing that flows steadily in a viscous fluid [-], Boyer, Guazzelli & Pouliquen 2011 (Phys. Rev.
/// Lett. 107, 188301):
///   phi_eq = phi_c/(1 + sqrt(I_v)),   I_v = eta gdot/p
/// phi_c [-] of slow flow, 0.585 for spheres. I_v is taken within [0, 1].
template <class Real>
HOST_DEVICE inline Real steady_solids(Real critical_solids, Real viscosity, Real strain_rate, Real pressure) {
  using std::sqrt;
  const Real shear = viscosity * strain_rate;
  const Real viscous_number = shear < pressure ? shear / pressure : Real(1);
  return critical_solids / (1 + sqrt(viscous_number));
}

/// Tangent of the angle of dilatancy [-], Roux & Radjai 1998, as Pailha & Pouliquen 2009 (J. Fluid Mech. 633, 115-135)
/// measured it:
///   tan psi = K (phi - phi_eq),   d phi/dt = -phi gdot tan psi
/// K = 4.09 for glass beads. Friction is that of steady flow plus tan psi. Taken within +-0.5.
/// phi = 0.60, phi_eq = 0.58: 0.0818.
template <class Real>
HOST_DEVICE inline Real dilatancy(Real coefficient, Real solids, Real steady) {
  const Real tangent = coefficient * (solids - steady);
  const Real most = Real(0.5);
  return tangent > most ? most : (tangent < -most ? -most : tangent);
}

}  // namespace thalweg
