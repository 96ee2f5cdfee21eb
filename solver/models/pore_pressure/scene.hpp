#pragma once

namespace thalweg {

/// Parameters of the excess pore pressure in a single-layer bed.
struct PoreScene {
  bool on = false;
  float consolidation = 0;  // c_v [m^2/s]
  float stiffness = 0;      // pore pressure over volume lost by the bed [Pa]
  // Dilatancy; critical_solids 0: none.
  float critical_solids = 0;  // share of solids in slow steady flow [-]
  float dilatancy = 0;        // tangent of the angle of dilatancy over the difference of shares of solids [-]
  float modulus = 0;          // pore pressure over volume that the pores lose [Pa]
  float solids_at_start = 0;  // share of solids [-]
  float water_viscosity = 0;  // [Pa s]
};

template <int Dim>
struct PorePressureScene {
  PoreScene pores;
};

}  // namespace thalweg
