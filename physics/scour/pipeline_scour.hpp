#pragma once

#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of pipeline_scour() and pipeline_time_scale() (pipeline_time_scale.hpp).
struct PipelineScour {
  double diameter = 0;          // D [m]
  double gap = 0;               // e [m], between the pipe's underside and the undisturbed bed; negative: buried
  double shields = 0;           // theta [-], of the undisturbed bed, by skin friction
  double critical_shields = 0;  // [-]
  double grain_diameter = 0;    // d [m]
  double relative_density = 0;  // s [-]
  double gravity = 9.81;        // g [m/s^2]
};

/// Standard deviation of the measured S/D around pipeline_scour() [-].
inline constexpr double pipeline_scour_deviation = 0.2;

/// Depth of the equilibrium scour hole under a pipe on the bed in a steady current [m], below the undisturbed bed:
/// 0.6 D, with a standard deviation of 0.2 D. Source: Sumer & Fredsoe 2002, The Mechanics of Scour in the Marine
/// Environment, chapter 2; live bed.
inline double pipeline_scour(const PipelineScour& pipe) { return 0.6 * pipe.diameter; }

/// Limits left: theta/theta_cr >= 1 (live bed); e/D within 0.05, which is our word for a pipe that lies on the bed.
inline std::vector<LimitLeft> limits_left(const PipelineScour& pipe) {
  return Limits()
      .at_least("theta/theta_cr", pipe.shields / pipe.critical_shields, 1)
      .between("e/D", pipe.gap / pipe.diameter, -0.05, 0.05)
      .left();
}

}  // namespace thalweg
