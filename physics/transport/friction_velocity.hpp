#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {

/// Result of friction_velocity().
template <class Real>
struct FrictionVelocity {
  Real friction_velocity = 0;  // u* [m/s]
  int iterations = 0;          // rounds of the log law until u* was accepted
};

/// Rounds of the fixed point after which u* is accepted as it is.
inline constexpr int most_friction_iterations = 20;

/// Height z0 [m] at which the log law's velocity vanishes, the paper's (19) (Nikuradse), with ks+ = u* ks/nu:
///   0.11 nu/u*              ks+ < 5         smooth
///   0.11 nu/u* + 0.033 ks   5 <= ks+ <= 70
///   0.033 ks                ks+ > 70        rough
/// The pieces do not meet: z0 changes by a factor of 2.5 at ks+ = 5 and by 5 % at 70.
/// Friction velocity u* > 0 [m/s], kinematic viscosity nu [m^2/s], roughness ks [m].
template <class Real>
HOST_DEVICE inline Real log_law_origin(Real friction_velocity, Real viscosity, Real roughness) {
  const Real ks_plus = friction_velocity * roughness / viscosity;
  const Real smooth = ks_plus > 70 ? Real(0) : Real(0.11) * viscosity / friction_velocity;
  const Real rough = ks_plus < 5 ? Real(0) : Real(0.033) * roughness;
  return smooth + rough;
}

/// Friction velocity u* [m/s] from the speed U along a wall [m/s] at the height z above it [m], the paper's (17)-(19):
///   U = u*^2 z/nu             z <= delta = 11.6 nu/u* and ks+ < 5 (viscous sublayer)
///   U = (u*/kappa) ln(z/z0)   otherwise, kappa = 0.41
/// The log law is solved by fixed point from u* = sqrt(U nu/z), until u* changes by less than 1e-3 of itself: 1 to 7
/// rounds. Around ks+ = 5 with z < ks the rounds may swing between the two sides of the step in z0 (26 of 151 000
/// combinations tried); the 20th is returned then.
/// z > 0; nu > 0 kinematic viscosity [m^2/s]; roughness ks [m] (0: smooth; d50 in the paper, 3 d90 in SPHERA).
/// Limit: the log law has no meaning among the roughness elements. z is taken as at least e z0, so that u* <= kappa U.
/// nu = 1e-6 m^2/s, ks = 3.5 mm: 0.0863 m/s for U = 0.6 m/s at 2 mm, 0.1157 m/s for U = 1 m/s at 4 mm.
template <class Real>
HOST_DEVICE inline FrictionVelocity<Real> friction_velocity(Real U, Real z, Real viscosity, Real roughness) {
  using std::exp;
  using std::fabs;
  using std::log;
  using std::sqrt;
  FrictionVelocity<Real> found;
  if (!(U > 0)) return found;
  constexpr Real kappa = von_karman<Real>;
  const Real laminar = sqrt(U * viscosity / z);
  found.friction_velocity = laminar;
  while (found.iterations < most_friction_iterations) {
    const Real last = found.friction_velocity;
    if (z * last < Real(11.6) * viscosity && last * roughness < 5 * viscosity) {
      found.friction_velocity = laminar;
      return found;
    }
    const Real z_over_z0 = z / log_law_origin(last, viscosity, roughness);
    found.friction_velocity = z_over_z0 > exp(Real(1)) ? kappa * U / log(z_over_z0) : kappa * U;
    ++found.iterations;
    if (fabs(found.friction_velocity - last) < Real(1e-3) * last) return found;
  }
  return found;
}

}  // namespace thalweg
