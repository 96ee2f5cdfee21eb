#pragma once

#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/material.hpp"

namespace thalweg {

/// Constants of the sediment as the passes use them: its law, and the effective pressure's.
struct SedimentScene : SedimentMaterial<float> {
  EffectivePressure effective_pressure = EffectivePressure::column;
  float submerged_weight = 0;   // (rho_bed - rho_pore) g [N/m^3]
  float suction = 0;            // [Pa] of the pore water where no water stands over the bed
  float pore_stiffness = 0;     // B_w [Pa], of the pressure from the equation of state
  float laplace_tolerance = 0;  // [Pa] change a sweep at which the iteration stops
};

/// Parameters of the bed model.
template <int Dim>
struct BedScene {
  SedimentScene sediment;
};

}  // namespace thalweg
