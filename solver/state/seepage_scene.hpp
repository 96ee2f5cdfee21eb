#pragma once

namespace thalweg {

/// What the passes of models/seepage/mixture.hpp and models/pore_pressure/pore_pressure.hpp need of a scene; all off by default.
struct SeepageScene {
  // Grains and pore water as two sets of particles in the same places.
  bool mixture = false;
  float solids_at_rest = 1;      // phi_0: share of the bed's volume that is grains [-]
  float grain_diameter = 0;      // [m]
  float skeleton_stiffness = 0;  // pressure of grain on grain over the compression of the packing [Pa]
  double fast_wave = 1;          // speed of pressure through grains and pore water over the sound speed [-]

  // Excess pore pressure carried by the particles of a single-layer bed.
  bool pore_pressure = false;
  float consolidation = 0;   // c_v [m^2/s]
  float pore_stiffness = 0;  // pore pressure over volume lost by the bed [Pa]
};

}  // namespace thalweg
