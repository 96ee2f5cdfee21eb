#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Prescribed motion of a rigid wall along or about a fixed unit vector e. One coordinate s(t) gives it: a distance [m]
// or an angle [rad]. A wall point that stands at X for s = 0, with r = x - c from a point c of the axis, has:
//   along e   x = X + s e                                     u = s' e        a = s'' e
//   about e   x = c + R(s e) (X - c), R by Rodrigues          u = s' e x r    a = s'' e x r + s'^2 e x (e x r)
// Places follow from X alone, so that rounding does not accumulate: after a whole turn a point is where it was.
namespace thalweg {

/// Line along or about which a wall moves.
struct RigidAxis {
  double direction[3] = {0, 0, 1};  // e
  double center[3] = {0, 0, 0};     // c [m]
  bool turns = false;               // true: about e; false: along it
};

/// Coordinate of the motion at one time, with its derivatives.
struct RigidState {
  double place = 0;   // s [m or rad]
  double rate = 0;    // s' [m/s or rad/s]
  double change = 0;  // s'' [m/s^2 or rad/s^2]
};

namespace rigid {

/// a x b, three entries each.
HOST_DEVICE inline void cross(const double* a, const double* b, double* out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/// e x (x - c) [m]
HOST_DEVICE inline void arm(const RigidAxis& axis, const double* x, double* out) {
  const double r[3] = {x[0] - axis.center[0], x[1] - axis.center[1], x[2] - axis.center[2]};
  cross(axis.direction, r, out);
}

}  // namespace rigid

/// Place x [m] of the point that stands at X = `from` [m] for s = 0. With -s it leads from x back to X.
HOST_DEVICE inline void moved_point(const RigidAxis& axis, double s, const double* from, double* to) {
  const double* e = axis.direction;
  if (!axis.turns || s == 0) {
    for (int c = 0; c < 3; ++c) to[c] = from[c] + (axis.turns ? 0 : s * e[c]);
    return;
  }
  const double sine = sin(s);
  const double half = sin(0.5 * s);
  const double versine = 2 * half * half;  // 1 - cos(s)
  double turned[3];
  rigid::arm(axis, from, turned);  // e x r
  double twice[3];
  rigid::cross(e, turned, twice);  // e x (e x r)
  for (int c = 0; c < 3; ++c) to[c] = from[c] + sine * turned[c] + versine * twice[c];
}

/// Velocity u [m/s] of the wall at the place x [m].
HOST_DEVICE inline void rigid_velocity(const RigidAxis& axis, double rate, const double* x, double* u) {
  double turned[3];
  rigid::arm(axis, x, turned);
  for (int c = 0; c < 3; ++c) u[c] = rate * (axis.turns ? turned[c] : axis.direction[c]);
}

/// Acceleration a [m/s^2] of the wall at the place x [m].
HOST_DEVICE inline void rigid_acceleration(const RigidAxis& axis, const RigidState& s, const double* x, double* a) {
  double turned[3];
  rigid::arm(axis, x, turned);
  double twice[3];
  rigid::cross(axis.direction, turned, twice);
  for (int c = 0; c < 3; ++c) {
    a[c] = axis.turns ? s.change * turned[c] + s.rate * s.rate * twice[c] : s.change * axis.direction[c];
  }
}

}  // namespace thalweg
