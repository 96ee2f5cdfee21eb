#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Tait's equation with exponent 7 on the density excess d = rho/rho0 - 1:
///   p = B [(1 + d)^7 - 1],  B = rho0 c^2 / 7   (Monaghan 1994)
/// coded as the polynomial B d (7 + 21d + 35d^2 + 35d^3 + 21d^4 + 7d^5 + d^6), which keeps the digits of a small d that
/// (1 + d)^7 - 1 would cancel: at p = 10 Pa and c = 20 m/s, d = 2.5e-5.
/// d [-]; stiffness B [Pa]; returns p [Pa].
template <class Real>
HOST_DEVICE inline Real tait_pressure(Real d, Real stiffness) {
  return stiffness * d * (7 + d * (21 + d * (35 + d * (35 + d * (21 + d * (7 + d))))));
}

/// The inverse: d = (1 + p/B)^(1/7) - 1 for p > -B; keeps the digits of a small p.
template <class Real>
HOST_DEVICE inline Real tait_excess(Real pressure, Real stiffness) {
  using std::expm1;
  using std::log1p;
  return expm1(log1p(pressure / stiffness) / 7);
}

/// B = rho0 c^2 / 7 [Pa] from density at rest [kg/m^3] and sound speed [m/s].
template <class Real>
HOST_DEVICE inline Real tait_stiffness(Real density_at_rest, Real sound_speed) {
  return density_at_rest * sound_speed * sound_speed / 7;
}

/// Internal energy per mass of compression from rest, e = integral p/rho^2 drho [J/kg]:
///   e = (c^2/7) [ (1+d)^6/6 + 1/(1+d) - 7/6 ],  e ~ c^2 d^2 / 2 for small d.
/// Below |d| = 1e-3 its series c^2 d^2 (1/2 + d/3 + d^2/2 + 0 d^3) keeps the digits the closed form cancels.
/// Derivation: p/rho^2 drho = (B/rho0) [(1+d)^5 - (1+d)^-2] dd.
HOST_DEVICE inline double tait_energy(double d, double sound_speed) {
  const double c2 = sound_speed * sound_speed;
  if (d > -1e-3 && d < 1e-3) return c2 * d * d * (0.5 + d * (1.0 / 3.0 + 0.5 * d));
  const double r = 1 + d;
  const double r2 = r * r;
  return c2 / 7 * (r2 * r2 * r2 / 6 + 1 / r - 7.0 / 6.0);
}

}  // namespace thalweg
