#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {

/// Height z [m] at which a logarithmic profile has its mean over the water in a kernel's reach, of the mean height `mean`
/// [m] and the variance `variance` of heights [m^2]:
///   z = mean exp(-min(0.38 variance/mean^2, 0.5))
/// The series of the mean logarithm begins with 1/2 in place of 0.38; layers of particles that thin out with the height
/// have a skewness that takes part of it back. 0.38 is within 2 % of exp(mean(ln z)) of lattices with h/dp from 1.5 to 2
/// whose particles are displaced by 0 to 0.2 dp, in two and three dimensions; 1/2 is 2 to 6 % low. The bound is for water
/// spread so widely that this says nothing.
template <class Real>
HOST_DEVICE inline Real log_mean_height(Real mean, Real variance) {
  const Real spread = Real(0.38) * variance / (mean * mean);
  return mean * std::exp(-(spread < Real(0.5) ? spread : Real(0.5)));
}

/// Friction velocity u* [m/s] of a wall from the mean speed U [m/s] of the water along it, whose mean height is `mean`
/// and whose log-mean height is z [m]: the larger of
///   U = u*^2 mean/nu                 the viscous sublayer
///   U = (u*/kappa) ln(z/z0),  z0 = 0.11 nu/u* + 0.033 ks,  kappa = 0.41     (Nikuradse; Colebrook's sum of the two)
/// They cross at z+ = 11.3 over a smooth wall. z0 is the sum for every ks+, so that u* is unique; the piecewise z0 of
/// friction_velocity() has two answers around ks+ = 5. The log law has no meaning among the roughness elements: z is
/// taken as at least e z0, so that there u* = kappa U.
/// f(u*) = u* ln(z/z0) - kappa U rises and is convex where ln(z/z0) >= 1, so that Newton's iteration from u* = kappa U
/// falls to the root: 3 to 6 rounds to single precision.
/// mean, z > 0; nu > 0 kinematic viscosity [m^2/s]; roughness ks >= 0 [m].
/// nu = 1e-6 m^2/s, U = 1 m/s, z = mean = 5 mm: 0.0527 m/s smooth, 0.0823 m/s with ks = 1 mm.
template <class Real>
HOST_DEVICE inline Real wall_friction_velocity(Real U, Real mean, Real z, Real viscosity, Real roughness) {
  if (!(U > 0)) return 0;
  constexpr int most_rounds = 12;
  const Real laminar = std::sqrt(U * viscosity / mean);
  const Real slowest = von_karman<Real> * U;
  const Real rough = Real(0.033) * roughness;
  Real turbulent = slowest;
  for (int round = 0; round < most_rounds; ++round) {
    const Real smooth = Real(0.11) * viscosity / turbulent;
    const Real origin = smooth + rough;
    const Real logarithm = std::log(z / origin);
    if (logarithm <= 1) break;
    const Real change = (turbulent * logarithm - slowest) / (logarithm + smooth / origin);
    turbulent -= change;
    if (change < Real(1e-6) * turbulent) break;
  }
  return turbulent > laminar ? turbulent : laminar;
}

}  // namespace thalweg
