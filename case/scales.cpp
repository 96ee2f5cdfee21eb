#include "case/scales.hpp"

#include <algorithm>
#include <cmath>

#include "case/models/openings.hpp"
#include "common/error.hpp"

namespace thalweg {

double maximum_speed(const Case& resolved, double fluid_height) {
  if (resolved.numerics.maximum_speed > 0) return resolved.numerics.maximum_speed;
  double speed = 2 * std::sqrt(resolved.domain.gravity.norm() * fluid_height);
  for (const Inlet& inlet : resolved.inlets) speed = std::max(speed, largest_inlet_speed(inlet, resolved));
  if (!(speed > 0))
    throw InputError(resolved.file.string() +
                     ": without gravity the sound speed cannot follow from the fluid's height; give "
                     "numerics.maximum_speed, the largest speed you expect");
  return speed;
}

double sound_speed(const Case& resolved, double fluid_height) {
  return resolved.numerics.sound_speed_factor * maximum_speed(resolved, fluid_height);
}

}  // namespace thalweg
