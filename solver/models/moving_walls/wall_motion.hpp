#pragma once

#include <cmath>
#include <vector>

#include "physics/rigid_motion.hpp"

namespace thalweg {

/// A part of a motion; it lasts until the next one begins. With tau = t - begin
///   s = place + rate tau + change tau^2/2 + amplitude (1 - cos(frequency tau))
struct MotionSegment {
  double begin = 0;      // [s]
  double place = 0;      // [m or rad]
  double rate = 0;       // [m/s or rad/s]
  double change = 0;     // [m/s^2 or rad/s^2]
  double amplitude = 0;  // [m or rad]
  double frequency = 0;  // [rad/s]

  [[nodiscard]] RigidState at(double t) const {
    const double tau = t - begin;
    const double phase = frequency * tau;
    return {place + tau * (rate + 0.5 * change * tau) + amplitude * (1 - std::cos(phase)),
            rate + change * tau + amplitude * frequency * std::sin(phase),
            change + amplitude * frequency * frequency * std::cos(phase)};
  }
};

/// One [[motion]] of the case; lives on the host, which hands passes its state at one time.
struct WallMotion {
  RigidAxis axis;
  std::vector<MotionSegment> segments;  // by time; at rest before the first
  bool stays = false;                   // the walls keep their places and only their surface moves, as a belt's

  /// At a kink of the motion the state is that after it.
  [[nodiscard]] RigidState at(double t) const {
    const MotionSegment* current = nullptr;
    for (const MotionSegment& segment : segments) {
      if (segment.begin <= t) current = &segment;
    }
    if (current == nullptr) return {segments.empty() ? 0 : segments.front().place, 0, 0};
    return current->at(t);
  }
};

}  // namespace thalweg
