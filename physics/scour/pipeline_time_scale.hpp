#pragma once

#include <cmath>

#include "physics/scour/pipeline_scour.hpp"

namespace thalweg {

/// Time scale T [s] of the hole under a pipe, S(t) = S_eq (1 - exp(-t/T)):
///   T sqrt(g (s - 1) d^3)/D^2 = (1/50) theta^(-5/3)
/// Source: Fredsoe, Sumer & Arnskov 1992 (Int. J. Offshore Polar Eng. 2(1)), live bed.
/// D = 0.05 m, theta = 0.33, d = 0.36 mm, s = 2.65: 11.5 s.
inline double pipeline_time_scale(const PipelineScour& pipe) {
  const double d = pipe.grain_diameter;
  const double unit = pipe.diameter * pipe.diameter / std::sqrt(pipe.gravity * (pipe.relative_density - 1) * d * d * d);
  return unit * std::pow(pipe.shields, -5.0 / 3) / 50;
}

}  // namespace thalweg
