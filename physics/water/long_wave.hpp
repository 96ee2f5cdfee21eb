#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Long waves where a scene ends. A wave is small beside the depth, and its velocity is the same over the depth; with the
// current's velocity U it travels with U + c downstream and with U - c upstream (Lagrange; Stoker 1957, Water Waves).
namespace thalweg {

/// c [m/s] in water of a depth [m].
HOST_DEVICE inline double wave_speed(double depth, double gravity) { return sqrt(gravity * depth); }

/// An end of a scene remembers that its level has changed for so many times the time in which a wave passes a length
/// of one depth. Then the level, or the discharge, is again what the case says.
inline constexpr double memory_of_waves = 30;

/// Height [m] of the waves that pass an end of a scene, a step of dt [s] after it was `before`. In the step the waves have
/// added `rise` [m] to the level.
HOST_DEVICE inline double swell_after(double before, double rise, double dt, double depth, double gravity) {
  const double subsides = dt * wave_speed(depth, gravity) / (memory_of_waves * depth);
  return before + rise - (subsides < 1 ? subsides : 1) * before;
}

/// Discharge per width [m^2/s] of a wave of a height [m] that runs against a current: what an inlet has to bring less, so
/// that the wave leaves through it.
HOST_DEVICE inline double discharge_of_wave_upstream(double height, double velocity, double depth, double gravity) {
  const double speed = wave_speed(depth, gravity) - velocity;
  return speed > 0 ? -speed * height : 0;
}

/// Height [m] that a change of discharge per width [m^2/s] adds to the water downstream of it: its wave runs with the
/// current.
HOST_DEVICE inline double height_of_wave_downstream(double discharge, double velocity, double depth, double gravity) {
  return discharge / (wave_speed(depth, gravity) + velocity);
}

}  // namespace thalweg
