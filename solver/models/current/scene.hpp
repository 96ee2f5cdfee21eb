#pragma once

#include "physics/water/current_control.hpp"

namespace thalweg {

/// The zone that guides a current (guide.hpp).
struct GuideZone {
  bool on = false;
  int component = 0;     // of vectors, along the flow
  double from = 0;       // [m]
  double length = 0;     // [m]
  double period = 0;     // [m] of the domain along the flow
  double roughness = 0;  // [m] of the ground
  double viscosity = 0;  // [m^2/s] of the water
};

/// The zone's guidance in a step.
struct Guide {
  double friction = 0;  // [m/s] of the profile
  double scale = 0;     // [-] of its velocities
  double rate = 0;      // [1/s]
  double next = 0;      // [m/s] friction of the step that follows
};

/// Constants of a driven current.
struct CurrentDrive {
  bool on = false;
  bool controlled = false;    // the acceleration follows the bulk velocity; else it stays
  int component = 0;          // of vectors, along the flow
  CurrentControl start;       // of a run that begins
  double start_friction = 0;  // [m/s] friction velocity of the current that is asked for
  GuideZone guide;
};

template <int Dim>
struct CurrentScene {
  CurrentDrive current;
};

}  // namespace thalweg
