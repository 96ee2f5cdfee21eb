#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of breusers_time() and breusers_scour().
struct BreusersScour {
  double depth = 0;              // lambda [m], depth of the flow before scour
  double velocity = 0;           // U0 [m/s], mean over the depth at the end of the bed protection
  double critical_velocity = 0;  // U_c [m/s], mean velocity at which the bed begins to move
  double relative_density = 0;   // s [-]
  double turbulence = 0;         // r0 [-], depth-averaged turbulence intensity at the end of the bed protection
  double exponent = 0.4;         // gamma [-]: 0.4 in two dimensions, up to 0.8 in three
};

/// alpha [-] by which turbulence raises the velocity that scours: 1.5 + 5 r0 (Hoffmans & Verheij 1997).
inline double breusers_velocity_factor(double turbulence) { return 1.5 + 5 * turbulence; }

/// Time t1 [s] in which a hole behind a bed protection becomes as deep as the flow was, infinite where nothing moves:
///   t1 = 330 lambda^2 (s - 1)^1.7/(alpha U0 - U_c)^4.3      [hours], lengths in m, velocities in m/s
/// Source: Breusers 1966, 1967; Hoffmans & Verheij 1997, Scour Manual. lambda = 1 m, U0 = 0.5 m/s, U_c = 0.4 m/s, s
/// = 2.65, r0 = 0.1: 25.0 million s.
inline double breusers_time(const BreusersScour& flow) {
  const double excess = breusers_velocity_factor(flow.turbulence) * flow.velocity - flow.critical_velocity;
  if (!(excess > 0)) return HUGE_VAL;
  constexpr double hour = 3600;
  const double weight = std::pow(flow.relative_density - 1, 1.7);
  return 330 * hour * flow.depth * flow.depth * weight / std::pow(excess, 4.3);
}

/// Greatest depth of the hole [m] at a time [s]: lambda (t/t1)^gamma, in the phase of its growth. With the depth at
/// equilibrium [m], if it is more than lambda: y_e (1 - (1 - lambda/y_e)^((t/t1)^gamma)), which ends there (same
/// source).
inline double breusers_scour(const BreusersScour& flow, double time, double equilibrium = HUGE_VAL) {
  const double growth = std::pow(time / breusers_time(flow), flow.exponent);
  if (!(equilibrium > flow.depth) || std::isinf(equilibrium)) return flow.depth * growth;
  return -equilibrium * std::expm1(growth * std::log1p(-flow.depth / equilibrium));
}

/// Limits left at a time [s]: y/lambda <= 1, up to which the power law grows as measured; alpha U0/U_c >= 1.
inline std::vector<LimitLeft> limits_left(const BreusersScour& flow, double time) {
  const double factor = breusers_velocity_factor(flow.turbulence);
  return Limits()
      .at_most("y/lambda", breusers_scour(flow, time) / flow.depth, 1)
      .at_least("alpha U0/Uc", factor * flow.velocity / flow.critical_velocity, 1)
      .left();
}

}  // namespace thalweg
