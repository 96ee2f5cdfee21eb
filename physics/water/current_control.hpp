#pragma once

#include "physics/host_device.hpp"

namespace thalweg {

/// Control of a current's bulk velocity U [m/s] by a uniform acceleration g of the water [m/s^2]:
///   g = D + (U_t - U)/T,   dD/dt = (g - dU/dt - D)/T
/// D is the drag on the current over its mass, as its balance shows it: g - dU/dt is the drag of walls, bed and bodies
/// together, whoever computes it. Fed forward it leaves U no reason to overshoot: with the true drag dU/dt = (U_t - U)/T,
/// and D follows the true drag with the time T. This is a proportional and integral control with the gains 2/T and 1/T^2.
/// T = 0.1 H/u* is short beside the time in which the drag changes (some H/u*), and long beside that of sound over H.
/// All numbers are state: they belong to a checkpoint.
struct CurrentControl {
  double target = 0;        // U_t [m/s]
  double time = 0;          // T [s]
  double velocity = 0;      // U [m/s] at the end of the last step
  double drag = 0;          // D [m/s^2]
  double acceleration = 0;  // g [m/s^2] of the next step
};

/// The control at its start, with the velocity that the water has and the drag that it is expected to feel.
HOST_DEVICE inline CurrentControl started(CurrentControl control) {
  control.acceleration = control.drag + (control.target - control.velocity) / control.time;
  return control;
}

/// After a step of dt [s] with control.acceleration, at whose end the water has the bulk velocity U [m/s].
HOST_DEVICE inline CurrentControl after_step(CurrentControl control, double velocity, double dt) {
  control.drag += (dt * (control.acceleration - control.drag) - (velocity - control.velocity)) / control.time;
  control.velocity = velocity;
  return started(control);
}

}  // namespace thalweg
