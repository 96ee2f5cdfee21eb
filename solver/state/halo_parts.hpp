#pragma once

#include "solver/state/record.hpp"

namespace thalweg {

/// The numbers of a rank's copies of particles that other ranks have. They lie one part after the other: fluid of the
/// ranks before this one, fluid of those behind it, and the same of walls, each part in the order of the lists.
struct HaloParts {
  Index fluid_before = 0;
  Index fluid_behind = 0;
  Index walls_before = 0;
  Index walls_behind = 0;

  [[nodiscard]] HOST_DEVICE Index count() const { return fluid_before + fluid_behind + walls_before + walls_behind; }
};

}  // namespace thalweg
