#pragma once

#include "physics/host_device.hpp"

// The skeleton of a bed is its grains without the fluid in its pores. Where grains and pore water are two sets of
// particles, the skeleton has an equation of state of its own, p = E (rho/rho_0 - 1).
namespace thalweg {

/// Stiffness E [Pa] of the skeleton: its pressure over its compression [-].
///
/// Derivation: under its own weight a packing at rest obeys dp/dz = -phi (rho_s - rho_w) g. With
///   E = phi (rho_s - rho_w) c^2
/// its compression grows by g/c^2 a metre of depth, as that of water at rest does.
///
/// Symbols: solids_share phi, the volume share of the grains at rest [-]; grain_density rho_s [kg/m^3]; pore_density
/// rho_w of the fluid in the pores [kg/m^3]; sound_speed c of the water [m/s].
/// Limits: grains heavier than that fluid; compressions much smaller than 1. E is a numerical constant: it follows from
/// the sound speed of the scene, not from the grains' contacts (oedometer_modulus is the physical one).
/// phi = 0.55, 1540 kg/m^3 in water, c = 20 m/s: 118.8 kPa.
template <class Real>
HOST_DEVICE inline Real skeleton_stiffness(Real solids_share, Real grain_density, Real pore_density, Real sound_speed) {
  return solids_share * (grain_density - pore_density) * sound_speed * sound_speed;
}

}  // namespace thalweg
