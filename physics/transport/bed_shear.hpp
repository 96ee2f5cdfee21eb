#pragma once

#include "physics/host_device.hpp"

// Shear stress of the water on the bed, and the stress that it is compared with. PVC grains of 3.5 mm, 1540 kg/m^3, in
// water begin to move at 1.11 Pa for a critical Shields number of 0.06.
namespace thalweg {

/// Law for the bed shear stress from the water beside the bed.
///   log_law   friction velocity (friction_velocity.hpp) of the mean of the water within reach; the default
///   nearest   the same law on the water particle closest to the bed, as in SPHERA
///   paper     the paper's (20), from the velocity difference alone
enum class BedShear { log_law, nearest, paper };

/// Bed shear stress tau_b = rho u*^2 [Pa], which defines the friction velocity u* [m/s]; rho density of the water
/// [kg/m^3]. u* = 0.0863 m/s: 7.44 Pa.
template <class Real>
HOST_DEVICE inline Real bed_shear_stress(Real water_density, Real friction_velocity) {
  return water_density * friction_velocity * friction_velocity;
}

/// Bed shear stress [Pa] by the paper's (20), from the velocity difference du across the interface [m/s]:
///   tau_b = rho [kappa (d/2) (du/d)]^2 = rho (kappa du/2)^2,   kappa = 0.41
/// The mixing length is half the distance d over which du is taken, so that d cancels. The law therefore knows no
/// height: it gives 1.2, 2.0, 3.1, 4.5 times the log law's stress for du taken 1, 2, 4, 8 mm above grains of 3.5 mm.
/// du = 0.6 m/s: 15.1 Pa; 1 m/s: 42.0 Pa.
template <class Real>
HOST_DEVICE inline Real bed_shear_stress_of_difference(Real water_density, Real velocity_difference) {
  const Real u = Real(0.205) * velocity_difference;
  return water_density * u * u;
}

/// Weight of a grain in water over its cross section, (rho_s - rho_w) g d [Pa], the unit of Shields numbers. rho_s is
/// the density of the grain itself, not of the saturated bed [kg/m^3]; d grain diameter [m]; g gravity [m/s^2].
/// PVC, 3.5 mm: 18.54 Pa.
template <class Real>
HOST_DEVICE inline Real grain_weight_stress(Real grain_density, Real water_density, Real gravity, Real diameter) {
  return (grain_density - water_density) * gravity * diameter;
}

/// Shields number theta = tau/((rho_s - rho_w) g d) [-] of a bed shear stress tau [Pa]. grain_weight: the stress of
/// grain_weight_stress() [Pa]. PVC, 3.5 mm, 7.44 Pa: 0.401.
template <class Real>
HOST_DEVICE inline Real shields_number(Real stress, Real grain_weight) {
  return stress / grain_weight;
}

/// Shear stress [Pa] at which a flat bed begins to move, theta_cr (rho_s - rho_w) g d, the paper's (15). theta_cr [-];
/// grain_weight as above [Pa].
template <class Real>
HOST_DEVICE inline Real critical_stress_of_flat_bed(Real critical_shields, Real grain_weight) {
  return critical_shields * grain_weight;
}

}  // namespace thalweg
