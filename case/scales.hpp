#pragma once

#include "case/case.hpp"

namespace thalweg {

/// Largest speed to expect [m/s]: numerics.maximum_speed, or where that is 0 the front of a dam break after Ritter,
/// 2 sqrt(g H), H being the height of the fluid at the start [m], or the speed of an inlet if that is more. Throws
/// InputError when neither gives a positive speed.
double maximum_speed(const Case& resolved, double fluid_height);

/// Numerical sound speed of every phase [m/s]: numerics.sound_speed_factor times maximum_speed.
/// Throws InputError as maximum_speed does.
double sound_speed(const Case& resolved, double fluid_height);

}  // namespace thalweg
