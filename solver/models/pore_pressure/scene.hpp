#pragma once

namespace thalweg {

/// Parameters of the excess pore pressure in a single-layer bed.
struct PoreScene {
  bool on = false;
  float consolidation = 0;  // c_v [m^2/s]
  float stiffness = 0;      // pore pressure over volume lost by the bed [Pa]
};

template <int Dim>
struct PorePressureScene {
  PoreScene pores;
};

}  // namespace thalweg
