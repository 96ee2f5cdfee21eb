#pragma once

#include "physics/host_device.hpp"

namespace thalweg {

/// Treatment in time of the viscosity of the sediment, and between water and sediment.
///   implicit         at the end of the step, by solving a linear system; the default
///   explicit_steps   from the velocities at the start, with steps short enough for the largest viscosity
///   capped           likewise, with the viscosity cut to what the acoustic step can take: a bed creeps
enum class ViscosityTreatment { implicit, explicit_steps, capped };

/// Longest stable step of an explicit treatment [s] (Morris, Fox & Zhu 1997, J. Comput. Phys. 136, 214-226):
///   0.125 h^2/nu
/// h smoothing length [m], nu kinematic viscosity [m^2/s]. h = 7.5 mm, nu = 1 m^2/s (a bed a few cm deep): 7.0e-6 s.
template <class Real>
HOST_DEVICE inline Real viscous_time_step(Real h, Real kinematic_viscosity) {
  return Real(0.125) * h * h / kinematic_viscosity;
}

/// Largest dynamic viscosity [Pa s] that a step dt [s] can take, the same limit solved for the viscosity:
///   0.125 rho h^2/dt
/// h = 4.16 mm, dt = 3.3e-5 s, 1540 kg/m^3: 101 Pa s.
template <class Real>
HOST_DEVICE inline Real viscosity_cap(Real density, Real h, Real dt) {
  return density * Real(0.125) * h * h / dt;
}

}  // namespace thalweg
