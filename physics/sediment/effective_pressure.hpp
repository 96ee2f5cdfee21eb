#pragma once

#include "physics/host_device.hpp"

// The share of the pressure that the grains carry among themselves, p_eff [Pa] >= 0 in compression: the yield criterion
// sees this one. It must not hold pressure of the pores or of the water above (docs/theory.md).
namespace thalweg {

/// Where the effective pressure comes from.
///   column    weight under water of the sediment above, column by column; the default
///   laplace   Laplace's equation in the bed, with that weight at walls and surface
///   (solver/models/bed/laplace_pressure.hpp) eos       a share of the equation of state's pressure; for comparison only
enum class EffectivePressure { column, laplace, eos };

/// Effective pressure [Pa] under a column of sediment, (rho_bed - rho_pore) g (z_surface - z) cos^2(slope):
/// submerged_weight = (rho_bed - rho_pore) g [N/m^3], height of sediment above [m]; cos^2(slope) for an endless slope,
/// where part of the weight is carried as shear along it. 1540 kg/m^3 in water: 317.8 Pa under 6 cm.
template <class Real>
HOST_DEVICE inline Real effective_pressure_of_column(Real submerged_weight, Real height_above, Real cos2_slope = 1) {
  return submerged_weight * height_above * cos2_slope;
}

/// Effective pressure [Pa] as the share of the equation of state's pressure p that is not the pores', Fourtakas &
/// Rogers 2016: p_pore = B_w [(rho/rho0_s)^7 - 1], hence p_eff = (1 - B_w/B_s) p, not below 0.
/// It does not vanish at the surface of the bed: under 0.1 m of water it adds 344 Pa for 1540 kg/m^3, more than the
/// 318 Pa that 6 cm of that bed weigh; and it carries every acoustic wave. For comparison only.
/// pore_stiffness B_w, bed_stiffness B_s [Pa].
template <class Real>
HOST_DEVICE inline Real effective_pressure_of_state(Real pressure, Real pore_stiffness, Real bed_stiffness) {
  const Real share = (1 - pore_stiffness / bed_stiffness) * pressure;
  return share > 0 ? share : Real(0);
}

}  // namespace thalweg
