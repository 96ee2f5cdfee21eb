#pragma once

#include "physics/no_slip.hpp"

namespace thalweg {

/// Parameters of walls that fluid sticks to: sediment always does, water if the case says so.
template <int Dim>
struct NoSlipScene {
  NoSlip<Dim> no_slip;
  bool water_sticks = false;
};

}  // namespace thalweg
