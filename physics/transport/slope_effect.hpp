#pragma once

#include "physics/host_device.hpp"

namespace thalweg {

/// Effect of the bed's slope along the flow on the bed load.
///   friction    it changes the stress of first motion (slope_factor.hpp) and the friction of the moving layer; the default
///   threshold   it changes the stress of first motion alone
/// Fernandez Luque & van Beek 1976 (J. Hydraul. Res. 14, 127-144) measured beds that fall along the flow: one law, with the
/// threshold of the slope, holds for them all. Where the stress is far above the threshold, a slope then hardly matters.
enum class SlopeEffect { friction, threshold };

/// Factor [-] on the bed load of a slope. With `friction`: tan(phi)/(tan(phi) + s), s the tangent of the rise along the
/// flow, taken as at least -0.67 tan(phi), where the factor is 3 (an avalanche goes on from there). 1 on a flat bed. 0.5
/// up the angle of repose. friction_tangent tan(phi) > 0. With `threshold`: 1.
/// Source: the balance of drag, weight and friction on a rolling layer (Bagnold 1956).
template <class Real>
HOST_DEVICE inline Real bed_load_slope_factor(SlopeEffect effect, Real rise, Real friction_tangent) {
  switch (effect) {
    case SlopeEffect::threshold:
      return 1;
    case SlopeEffect::friction:
      break;
  }
  const Real least = Real(-0.67) * friction_tangent;
  return friction_tangent / (friction_tangent + (rise > least ? rise : least));
}

}  // namespace thalweg
