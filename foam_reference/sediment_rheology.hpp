#pragma once

#include "case/case.hpp"
#include "foam_reference/mesh_plan.hpp"
#include "physics/sediment/material.hpp"

namespace thalweg::foam {

/// Constants of OpenFOAM's own HerschelBulkley model as those of a dynamic viscosity:
///   eta = min(cap, tau_0 / gdot + k gdot^(n-1)),   gdot = sqrt(2 D:D)
/// The dictionary takes them divided by the phase's density (kinematic).
struct StockRheology {
  double density = 0;             // [kg/m^3] of the saturated bed
  double yield_stress = 0;        // tau_0 [Pa]
  double consistency = 0;         // k [Pa s^n]
  double flow_index = 1;          // n [-]
  double viscosity_cap = 0;       // [Pa s]
  double yield_coefficient = 0;   // K [-] of the Drucker-Prager criterion
  double effective_pressure = 0;  // p_eff [Pa] that K is applied to
};

/// The law of the scene's sediment, as the particle model has it.
SedimentMaterial<double> sediment_material(const Case& scene);

/// Constants of the stock model for the scene's sediment. The particle model's yield stress K p_eff + c_0 grows with
/// depth, but the stock model has one yield stress. It gets the value at the middle of the bed at the start:
///   p_eff = (rho_bed - rho_pore) |g| H / 2,   H mean thickness of the columns that hold sediment [m]
/// So the top of the bed is too strong and its base too weak. The cap is the particle model's viscosity at rest,
/// tau_0 m/2 + k with Papanastasiou's m.
StockRheology stock_rheology(const Case& scene, const SceneContents& contents);

}  // namespace thalweg::foam
