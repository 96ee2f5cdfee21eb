#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/transport/wall_stress.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {

/// Height z0 [m] at which the logarithmic profile has no velocity: 0.11 nu/u* + 0.033 ks, smooth and rough walls together
/// (Nikuradse; Colebrook). u* > 0 [m/s], nu [m^2/s] kinematic viscosity, ks >= 0 [m] roughness.
template <class Real>
HOST_DEVICE inline Real profile_origin(Real friction_velocity, Real viscosity, Real roughness) {
  return Real(0.11) * viscosity / friction_velocity + Real(0.033) * roughness;
}

/// Velocity (u*/kappa) ln(z/z0) [m/s] of a current at the height z [m] over its bed, kappa = 0.41; 0 below z0.
/// u* = 0.044 m/s, z = 50 mm, nu = 1e-6 m^2/s, ks = 1 mm: 0.7783 m/s.
template <class Real>
HOST_DEVICE inline Real log_profile(Real friction_velocity, Real z, Real viscosity, Real roughness) {
  using std::log;
  const Real origin = profile_origin(friction_velocity, viscosity, roughness);
  return z > origin ? friction_velocity / von_karman<Real> * log(z / origin) : Real(0);
}

/// Friction velocity u* [m/s] of a current with the depth-mean velocity U [m/s] and the depth H [m]. The mean of ln(z/z0)
/// over the depth is ln(H/(e z0)), so that U is the velocity of the profile at H/e (z0 << H).
template <class Real>
HOST_DEVICE inline Real friction_velocity_of_current(Real mean_velocity, Real depth, Real viscosity, Real roughness) {
  using std::exp;
  const Real height = depth * exp(Real(-1));
  return wall_friction_velocity(mean_velocity, height, height, viscosity, roughness);
}

}  // namespace thalweg
