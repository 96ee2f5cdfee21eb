#pragma once

#include "physics/water/current_control.hpp"

namespace thalweg {

/// Constants of a driven current.
struct CurrentDrive {
  bool on = false;
  bool controlled = false;  // the acceleration follows the bulk velocity; else it stays
  int component = 0;        // of vectors, along the flow
  CurrentControl start;     // of a run that begins
};

template <int Dim>
struct CurrentScene {
  CurrentDrive current;
};

}  // namespace thalweg
