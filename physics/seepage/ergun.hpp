#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Exchange of momentum between grains and the water that moves through them. Per volume of mixture [N/m^3]
//   f = beta w,   w = v_water - v_grains
// acts on the grains and, reversed, on the water. In steady flow through grains at rest n (-grad p) = beta w.
// The laws give beta/phi [kg/(m^3 s)], which stays finite when the last grain leaves.
// Symbols: porosity n, 0 < n < 1, and share of solids phi = 1 - n [-]; grain diameter d [m]; slip |w| [m/s]; of the
// water, dynamic viscosity mu [Pa s] and density rho [kg/m^3]; gravity g [m/s^2].
namespace thalweg {

/// Permeability k of a packed bed [m^2], the laminar part of Ergun 1952 (Chem. Eng. Prog. 48, 89-94), Kozeny-Carman:
///   k = n^3 d^2/(150 (1 - n)^2)
/// d = 3.5 mm, n = 0.45: 2.46e-8 m^2.
template <class Real>
HOST_DEVICE inline Real permeability(Real n, Real d) {
  return n * n * n * d * d / (150 * (1 - n) * (1 - n));
}

/// Hydraulic conductivity K = k rho g/mu [m/s], the filter velocity n |w| under the hydraulic gradient 1 as long as the
/// flow is laminar. The same grains in water: 0.24 m/s, several times as much as Ergun's full law gives there.
template <class Real>
HOST_DEVICE inline Real hydraulic_conductivity(Real permeability, Real density, Real viscosity, Real gravity) {
  return permeability * density * gravity / viscosity;
}

/// Ergun 1952 for packed beds, n below about 0.8 [kg/(m^3 s)]:
///   beta/phi = 150 mu phi/(n d^2) + 1.75 rho |w|/d
template <class Real>
HOST_DEVICE inline Real ergun_drag(Real n, Real d, Real slip, Real viscosity, Real density) {
  return 150 * viscosity * (1 - n) / (n * d * d) + Real(1.75) * density * slip / d;
}

/// Wen & Yu 1966 (Chem. Eng. Prog. Symp. Ser. 62, 100-111) for suspensions, n above about 0.8 [kg/(m^3 s)]:
///   beta/phi = (3/4) C_D n rho |w|/d n^-2.65,   Re = n rho |w| d/mu
///   C_D = (24/Re) (1 + 0.15 Re^0.687)   Re < 1000   (Schiller & Naumann 1933)
///         0.44                          beyond, 0.4 % apart at Re = 1000
/// It is coded on C_D Re/24, which is 1 at rest. A suspension then settles at w0 n^4.65 in creeping flow and at
/// w0 n^2.325 in turbulent flow, with the exponents of Richardson & Zaki 1954; w0 settling velocity of one grain.
template <class Real>
HOST_DEVICE inline Real wen_yu_drag(Real n, Real d, Real slip, Real viscosity, Real density) {
  using std::pow;
  const Real reynolds = n * density * slip * d / viscosity;
  const Real over_stokes =
      reynolds < 1000 ? 1 + Real(0.15) * pow(reynolds, Real(0.687)) : Real(0.44) * reynolds / 24;  // C_D Re/24
  return 18 * viscosity / (d * d) * over_stokes * pow(n, Real(-2.65));
}

/// Gidaspow 1994: Ergun's law in the bed (n < 0.8), Wen & Yu's in suspension. The two do not meet at n = 0.8.
template <class Real>
HOST_DEVICE inline Real grain_drag(Real n, Real d, Real slip, Real viscosity, Real density) {
  return n < Real(0.8) ? ergun_drag(n, d, slip, viscosity, density) : wen_yu_drag(n, d, slip, viscosity, density);
}

/// Slip |w| [m/s] at which n F = beta |w|. F is the driving force per volume of pores [N/m^3]: -grad p - rho_w g for
/// flow through a bed at rest, phi (rho_grain - rho_water) g for a suspension that settles; 0 for F <= 0.
/// Newton's method, since the balance rises with |w| and is convex. The slip jumps at n = 0.8, as the law does.
inline double steady_slip(double n, double d, double force, double viscosity, double density) {
  const auto balance = [&](double w) { return (1 - n) * grain_drag(n, d, w, viscosity, density) * w - n * force; };
  double w = force > 0 ? n * force / ((1 - n) * grain_drag(n, d, 0.0, viscosity, density)) : 0;
  for (int i = 0; i < 60 && w > 0; ++i) {
    const double step = balance(w) / ((balance(w * (1 + 1e-6)) - balance(w)) / (1e-6 * w));
    w -= step;
    if (std::abs(step) < 1e-10 * w) break;
  }
  return w;
}

}  // namespace thalweg
