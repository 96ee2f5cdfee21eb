#pragma once

#include <algorithm>

#include "physics/water/long_wave.hpp"
#include "solver/models/openings/openings.hpp"

namespace thalweg {

/// Waves that come to an inlet out of the scene and leave through it. They are what the level next to the inlet rises and
/// falls by, apart from the waves that the inlet's own discharge makes.
struct WavesOut {
  double level = 0;          // [m] without the inlet's own waves, smooth over time
  double height = 0;         // [m] of the waves
  bool is_measured = false;  // the level is known

  /// discharge: asked of the inlet, per width [m^2/s]; dt: since the last measurement [s]. What the pressure says of the
  /// level is smoothed over the time in which a wave passes a length of one depth, because sound crosses it meanwhile.
  void measure(const WaterAtOpening& water, double discharge, double dt, double gravity) {
    const double own = height_of_wave_downstream(discharge, discharge / water.depth, water.depth, gravity);
    const double now = water.level - own;
    if (!is_measured) level = now;
    is_measured = true;
    const double rise = std::min(1.0, dt * wave_speed(water.depth, gravity) / water.depth) * (now - level);
    level += rise;
    height = swell_after(height, rise, dt, water.depth, gravity);
  }

  /// The surplus that the inlet brings beside what is asked of it, per width [m^2/s].
  [[nodiscard]] double discharge(double asked, double depth, double gravity) const {
    return height != 0 && depth > 0 ? discharge_of_wave_upstream(height, asked / depth, depth, gravity) : 0;
  }
};

}  // namespace thalweg
