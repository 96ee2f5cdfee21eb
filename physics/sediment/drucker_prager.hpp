#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// How a friction angle becomes the coefficient K of sqrt(J2) <= K p_eff + c_0, p_eff >= 0 in compression.
enum class YieldFit { sine, coulomb, outer, inner, plane_strain, paper };

/// K [-] of the Drucker-Prager criterion for friction angle phi [rad], 0 <= phi < pi/2.
///   outer, inner   6 sin(phi) / (sqrt3 (3 -+ sin(phi)))   the cones around and inside Mohr-Coulomb's hexagon
///   plane_strain   3 tan(phi) / sqrt(9 + 12 tan^2(phi))   plane strain with dilation = friction
///   sine           sin(phi)                               plane strain without dilation; the default for a flume
///   coulomb        tan(phi)                               slip along the shear plane: a slope stands up to phi itself
///   paper          2 sin(phi) / (sqrt3 (3 - sin(phi)))    the paper's (10), which is the coefficient of I1 = 3p, used
///   on p
/// A long slope stands up to the angle whose tangent is K: atan(sin(phi)) with `sine`, 31.6 deg for phi = 38 deg.
/// phi = 38 deg: 0.616, 0.781 (coulomb), 0.894, 0.590, 0.580 (plane_strain), 0.298 (paper).
template <class Real>
HOST_DEVICE inline Real yield_pressure_coefficient(Real phi, YieldFit fit) {
  using std::sin;
  using std::sqrt;
  using std::tan;
  const Real s = sin(phi);
  const Real sqrt3 = sqrt(Real(3));
  switch (fit) {
    case YieldFit::outer:
      return 6 * s / (sqrt3 * (3 - s));
    case YieldFit::inner:
      return 6 * s / (sqrt3 * (3 + s));
    case YieldFit::plane_strain: {
      const Real t = tan(phi);
      return 3 * t / sqrt(9 + 12 * t * t);
    }
    case YieldFit::coulomb:
      return tan(phi);
    case YieldFit::paper:
      return 2 * s / (sqrt3 * (3 - s));
    case YieldFit::sine:
      break;
  }
  return s;
}

/// Yield stress without pressure [Pa] for cohesion c [Pa], matched to the same edge as the coefficient:
///   outer, inner, paper   6 c cos(phi) / (sqrt3 (3 -+ sin(phi)))   (misprinted "6 c sin" in the paper)
///   plane_strain          3 c / sqrt(9 + 12 tan^2(phi));   sine   c cos(phi);   coulomb   c
template <class Real>
HOST_DEVICE inline Real yield_cohesion_term(Real cohesion, Real phi, YieldFit fit) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  const Real sqrt3 = sqrt(Real(3));
  switch (fit) {
    case YieldFit::outer:
    case YieldFit::paper:
      return 6 * cohesion * cos(phi) / (sqrt3 * (3 - sin(phi)));
    case YieldFit::inner:
      return 6 * cohesion * cos(phi) / (sqrt3 * (3 + sin(phi)));
    case YieldFit::plane_strain: {
      const Real t = tan(phi);
      return 3 * cohesion / sqrt(9 + 12 * t * t);
    }
    case YieldFit::coulomb:
      return cohesion;
    case YieldFit::sine:
      break;
  }
  return cohesion * cos(phi);
}

}  // namespace thalweg
