#pragma once

namespace thalweg {

/// Parameters of the shifting (shifting.hpp has the formula).
template <int Dim>
struct ShiftingScene {
  bool has_shifting = false;
  int shifting_interval = 1;          // steps from one shift to the next
  bool shifting_keeps_level = false;  // densities follow the packing
  float pressing = 0;                 // sum of two pressures from which on a pair is pressed together [Pa]
  float inverse_spacing_kernel = 0;   // 1/W(dp) [m^Dim]
};

}  // namespace thalweg
