#pragma once

namespace thalweg {

/// Constants of a bed that is a surface.
struct SurfaceBedConstants {
  bool on = false;
  float roughness = 0;     // ks of its grains [m]
  float grain_stress = 1;  // share of the shear stress that moves grains [-]
  float tan_friction = 0;  // of its slopes at rest [-]
  float density = 0;       // of the bed in particle files [kg/m^3]
  int rows_in_reach = 0;   // rows that water may feel, which keep a spacing's distance
};

template <int Dim>
struct SurfaceBedScene {
  SurfaceBedConstants surface_bed;
};

}  // namespace thalweg
