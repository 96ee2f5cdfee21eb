#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "common/app/scour/scene.hpp"

namespace thalweg {

/// A height or length [m] that a case tells, and who tells it; or the reason why it is not known.
struct Level {
  double height = std::numeric_limits<double>::quiet_NaN();
  std::string origin;

  [[nodiscard]] bool is_known() const { return !std::isnan(height); }
};

/// The height at which all shapes of a role end upwards, if it is one height and can be read.
Level top_of(const Case& scene, ShapeRole role);

/// Length of the way from an inlet's plane along its flow to the first sediment.
Level apron_before(const Case& scene, const Inlet& inlet);

/// Adds piers, pipes and a contraction; the bed's level tells what stands in it.
void read_obstacles(const Case& scene, const Level& bed, SceneReading& reading);

}  // namespace thalweg
