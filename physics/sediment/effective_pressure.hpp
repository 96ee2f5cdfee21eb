#pragma once

#include "physics/host_device.hpp"

// Effective pressure p_eff [Pa], >= 0 in compression: the share of the pressure that the grains carry among themselves.
// The yield criterion uses this pressure alone. It must hold neither the pressure of the pores nor that of the water
// above (docs/theory.md).
namespace thalweg {

/// Source of the effective pressure.
///   column    the weight under water of the sediment above, column by column; the default
///   laplace   Laplace's equation in the bed with that weight at walls and surface
///             (solver/models/bed/laplace_pressure.hpp)
///   eos       a share of the pressure from the equation of state; for comparison only
///   total     all of that pressure, as the paper's (9) and (14) print it; for comparison only
///   grains    the pressure of the grains of a mixture on each other (solver/models/seepage): water that seeps upwards
///             takes it away, downwards adds to it
enum class EffectivePressure { column, laplace, eos, total, grains };

/// Weight of the bed under water per volume (rho_bed - rho_pore) g [N/m^3]. Densities of the bed as a whole and of the
/// fluid in its pores [kg/m^3], gravity g [m/s^2]. 1540 kg/m^3 in water: 5297 N/m^3.
template <class Real>
HOST_DEVICE inline Real submerged_weight(Real bed_density, Real pore_density, Real gravity) {
  return (bed_density - pore_density) * gravity;
}

/// Effective pressure [Pa] under a column of sediment:
///   p_eff = (rho_bed - rho_pore) g (z_surface - z) cos^2(slope)
/// submerged_weight (rho_bed - rho_pore) g [N/m^3]; height_above z_surface - z of sediment [m], >= 0.
/// cos^2(slope) [-] holds for an endless slope: shear along the slope carries the rest of the weight.
/// 1540 kg/m^3 in water: 317.8 Pa under 6 cm.
template <class Real>
HOST_DEVICE inline Real effective_pressure_of_column(Real submerged_weight, Real height_above, Real cos2_slope = 1) {
  return submerged_weight * height_above * cos2_slope;
}

/// Effective pressure [Pa] as the share of the pressure p of the equation of state that the pores do not carry
/// (Fourtakas & Rogers 2016):
///   p_pore = B_w [(rho/rho0_s)^7 - 1],   hence   p_eff = (1 - B_w/B_s) p,   not below 0
/// pressure p, pore_stiffness B_w, bed_stiffness B_s [Pa].
/// For comparison only, for two reasons. It does not vanish at the surface of the bed: 0.1 m of water add 344 Pa for
/// 1540 kg/m^3, more than the 318 Pa that 6 cm of that bed weigh. And it carries every acoustic wave.
template <class Real>
HOST_DEVICE inline Real effective_pressure_of_state(Real pressure, Real pore_stiffness, Real bed_stiffness) {
  const Real share = (1 - pore_stiffness / bed_stiffness) * pressure;
  return share > 0 ? share : Real(0);
}

}  // namespace thalweg
