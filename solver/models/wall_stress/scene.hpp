#pragma once

namespace thalweg {

/// Constants of the walls' shear stress.
struct WallStress {
  bool on = false;
  float viscosity = 0;  // of water, kinematic [m^2/s]
  float contact = 0;    // sum of V W over half a layer of water on the wall [-]; with less the wall is partly wet
  float most_drag = 0;  // of stress over density and speed [m/s]; more would overshoot in one step
};

template <int Dim>
struct WallStressScene {
  WallStress wall_stress;
};

}  // namespace thalweg
