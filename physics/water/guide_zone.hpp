#pragma once

#include "physics/host_device.hpp"

// A guide zone at the seam of a periodic flume: it turns the wake that comes around the period back into the current that
// an infinite flume would bring. Over its length
//   du/dt += ramp (s u_log - u)/tau,   dw/dt += -ramp w/tau
// u_log the logarithmic profile, tau a fifth of the time in which the current passes. s = sum m ramp u/sum m ramp u_log makes
// it neutral: it neither drives the flow nor brakes it, whatever the profile.
namespace thalweg {

/// Share of the guide [-] at a distance from the zone's begin [m]: rises and falls over a quarter of the zone's length
/// [m] at both ends; 0 outside.
template <class Real>
HOST_DEVICE inline Real guide_ramp(Real along, Real length) {
  const Real quarters = 4 * along / length;
  const Real left = 4 - quarters;
  const Real least = quarters < left ? quarters : left;
  return least > 1 ? Real(1) : least > 0 ? least : Real(0);
}

/// Rate 1/tau [1/s] of a zone of a length [m] in a current of a velocity [m/s]. The deviation falls to e^-3.75 on the way
/// through, the mean of the ramp being three quarters.
template <class Real>
HOST_DEVICE inline Real guide_rate(Real velocity, Real length) {
  return velocity > 0 ? 5 * velocity / length : Real(0);
}

}  // namespace thalweg
