#pragma once

#include "physics/host_device.hpp"

// Shear stress of the water on the bed and what it is measured against. PVC grains of 3.5 mm, 1540 kg/m^3, in water:
// at rest they move at 1.11 Pa for a critical Shields number of 0.06.
namespace thalweg {

/// How the bed shear stress follows from the water beside the bed.
///   log_law   friction velocity of the mean water within reach (physics/transport/friction_velocity.hpp); the default
///   nearest   the same law on the water particle closest to the bed (SPHERA's choice)
///   paper     the paper's (20), from the velocity difference alone
enum class BedShear { log_law, nearest, paper };

/// Bed shear stress [Pa] tau_b = rho u*^2 from water density [kg/m^3] and friction velocity [m/s].
/// u* = 0.0863 m/s: 7.44 Pa.
template <class Real>
HOST_DEVICE inline Real bed_shear_stress(Real water_density, Real friction_velocity) {
  return water_density * friction_velocity * friction_velocity;
}

/// Bed shear stress [Pa] as the paper's (20) has it, tau_b = rho [kappa (d/2) (du/d)]^2 = rho (kappa du/2)^2, kappa =
/// 0.41, from the velocity difference du across the interface [m/s]: a mixing length of half the distance over which du
/// is taken. It knows no height: 1.2, 2.0, 3.1, 4.5 times the log law's stress for du taken 1, 2, 4, 8 mm above grains
/// of 3.5 mm. du = 0.6 m/s: 15.1 Pa; 1 m/s: 42.0 Pa.
template <class Real>
HOST_DEVICE inline Real bed_shear_stress_of_difference(Real water_density, Real velocity_difference) {
  const Real u = Real(0.205) * velocity_difference;
  return water_density * u * u;
}

/// Weight of a grain in water over its cross section, (rho_s - rho_w) g d [Pa], the unit of Shields numbers. rho_s is
/// the density of the grain itself, not of the saturated bed [kg/m^3]; d grain diameter [m]. PVC, 3.5 mm: 18.54 Pa.
template <class Real>
HOST_DEVICE inline Real grain_weight_stress(Real grain_density, Real water_density, Real gravity, Real diameter) {
  return (grain_density - water_density) * gravity * diameter;
}

/// Shields number theta = tau/((rho_s - rho_w) g d) [-] of a bed shear stress [Pa]. PVC, 3.5 mm, 7.44 Pa: 0.401.
template <class Real>
HOST_DEVICE inline Real shields_number(Real stress, Real grain_weight) {
  return stress / grain_weight;
}

/// Shear stress [Pa] at which a flat bed begins to move, theta_cr (rho_s - rho_w) g d, the paper's (15).
template <class Real>
HOST_DEVICE inline Real critical_stress_of_flat_bed(Real critical_shields, Real grain_weight) {
  return critical_shields * grain_weight;
}

}  // namespace thalweg
