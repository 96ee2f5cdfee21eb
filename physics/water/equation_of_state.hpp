#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Tait's equation with exponent 7 on the density excess d = rho/rho0 - 1:
///   p = B [(1 + d)^7 - 1],  B = rho0 c^2 / 7   (Monaghan 1994)
/// It is coded as the polynomial B d (7 + 21d + 35d^2 + 35d^3 + 21d^4 + 7d^5 + d^6). This keeps the digits of a small
/// d, which cancel in (1 + d)^7 - 1: at p = 10 Pa and c = 20 m/s, d = 2.5e-5.
/// d [-]; stiffness B [Pa]; returns p [Pa]. For slightly compressible flow, |d| of a few percent.
template <class Real>
HOST_DEVICE inline Real tait_pressure(Real d, Real stiffness) {
  return stiffness * d * (7 + d * (21 + d * (35 + d * (35 + d * (21 + d * (7 + d))))));
}

/// Density excess d [-] of a pressure p [Pa], the inverse of tait_pressure():
///   d = (1 + p/B)^(1/7) - 1,   p > -B
/// It is coded with expm1 and log1p, which keep the digits of a small p.
template <class Real>
HOST_DEVICE inline Real tait_excess(Real pressure, Real stiffness) {
  using std::expm1;
  using std::log1p;
  return expm1(log1p(pressure / stiffness) / 7);
}

/// Pressure [Pa] of the acoustic damper, a bulk viscosity that acts on sound alone:
///   p_d = a rho0 c h d',   d' the rate of the density excess
/// Flow that keeps its volume has d' = 0, shear as well as strain: there the damper takes nothing. Of a standing sound
/// wave of wave number k the share exp(-a c h k^2 t/2) is left; one four smoothing lengths long falls to 1/e in 0.8 h/(a c).
/// a [-]; density_at_rest rho0 [kg/m^3]; damping = a c h [m^2/s]; excess_rate d' [1/s].
/// Limit: it is explicit in time. A mode whose div grad is (g/h)^2 is stable for C a g^2/2 + C^2 g^2/4 < 1, C the acoustic
/// Courant number. On the lattice g is about 1, which is stable for a = 1 up to C = 0.8. But g may come up to
/// h int |grad W| = 2.33 in the plane (3.0 in space) where particles have gathered in knots and rings; then C = 0.5 allows
/// a = 0.49, and C = 0.7 allows 0.18. With a = 1 one splash of 20 flung its knots apart, by 16 % a step.
template <class Real>
HOST_DEVICE inline Real damper_pressure(Real density_at_rest, Real damping, Real excess_rate) {
  return density_at_rest * damping * excess_rate;
}

/// Stiffness B = rho0 c^2 / 7 [Pa] from the density at rest rho0 [kg/m^3] and the sound speed c [m/s], with which small
/// waves run: dp/drho = c^2 at d = 0.
template <class Real>
HOST_DEVICE inline Real tait_stiffness(Real density_at_rest, Real sound_speed) {
  return density_at_rest * sound_speed * sound_speed / 7;
}

/// Internal energy of compression from rest [J/kg], e = integral p/rho^2 drho:
///   e = (c^2/7) [(1+d)^6/6 + 1/(1+d) - 7/6],   e ~ c^2 d^2/2 for small d
/// Derivation: p/rho^2 drho = (B/rho0) [(1+d)^5 - (1+d)^-2] dd.
/// Below |d| = 1e-3 the series c^2 d^2 (1/2 + d/3 + d^2/2 + 0 d^3) keeps the digits that cancel in the closed form.
/// d [-]; sound_speed c [m/s].
HOST_DEVICE inline double tait_energy(double d, double sound_speed) {
  const double c2 = sound_speed * sound_speed;
  if (d > -1e-3 && d < 1e-3) return c2 * d * d * (0.5 + d * (1.0 / 3.0 + 0.5 * d));
  const double r = 1 + d;
  const double r2 = r * r;
  return c2 / 7 * (r2 * r2 * r2 / 6 + 1 / r - 7.0 / 6.0);
}

}  // namespace thalweg
