#pragma once

#include "solver/models/all.hpp"

namespace thalweg::test {

/// Erosion of the PVC grains of the Louvain flume (3.5 mm, 1540 kg/m^3) by water, with the model's own criteria.
template <int Dim>
ErosionScene<Dim> erosion_of_pvc() {
  constexpr float g = 9.81F;
  ErosionScene<Dim> e;
  e.surface_fill = 0.85F;
  e.fill_hysteresis = 0.07F;
  e.diameter = e.roughness = 3.5e-3F;
  e.grain_density = 1540;
  e.grain_weight = 540 * g * 3.5e-3F;
  e.gravity = g;
  e.down.vertical() = -1;
  e.lift_ratio = 0.85F;
  e.dimensionless_diameter = 61.01F;
  e.settling_velocity = 0.1365F;
  e.dilute = 0.312F;
  e.dense = 0.33F;
  e.return_stress = 0.8F;
  e.return_speed = 2e-3F;
  e.return_time = 0.019F;
  e.solids_share = 0.53F;
  return e;
}

}  // namespace thalweg::test
