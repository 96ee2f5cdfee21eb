#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// The Drucker-Prager criterion: sediment does not flow while
//   sqrt(J2) <= K p_eff + c_0
// J2 second invariant of the deviatoric stress [Pa^2], p_eff effective pressure [Pa], >= 0 in compression. This cone in
// the space of principal stresses meets Mohr-Coulomb's hexagonal pyramid along one edge or in one state only; the yield
// fit says which. K and c_0 follow from putting that edge's Lode angle, or plane strain, into Mohr-Coulomb's criterion
// (mohr_coulomb.hpp).
namespace thalweg {

/// The way from a friction angle and a cohesion to K and c_0.
enum class YieldFit { sine, coulomb, outer, inner, plane_strain, paper, printed };

/// K [-] for the friction angle phi [rad], 0 <= phi < pi/2. The last column: phi = 38 deg.
///   sine           sin(phi)                               0.616   plane strain without dilation; the default
///   coulomb        tan(phi)                               0.781   slip along the shear plane
///   outer          6 sin(phi) / (sqrt3 (3 - sin(phi)))    0.894   the cone around Mohr-Coulomb's hexagon
///   inner          6 sin(phi) / (sqrt3 (3 + sin(phi)))    0.590   the cone through the hexagon's inner corners
///   plane_strain   3 tan(phi) / sqrt(9 + 12 tan^2(phi))   0.580   plane strain with dilation = friction
///   paper, printed 2 sin(phi) / (sqrt3 (3 - sin(phi)))    0.298   the paper's (10): made for I1 = 3p, used on p
/// A long slope stands up to the angle whose tangent is K: phi itself with `coulomb`, atan(sin(phi)) with `sine`,
/// which is 31.6 deg for phi = 38 deg.
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
    case YieldFit::printed:
      return 2 * s / (sqrt3 * (3 - s));
    case YieldFit::sine:
      break;
  }
  return s;
}

/// Yield stress without pressure c_0 [Pa] for the cohesion c [Pa], matched to the same edge as K:
///   sine           c cos(phi)
///   coulomb        c
///   outer, paper   6 c cos(phi) / (sqrt3 (3 - sin(phi)))
///   printed        6 c sin(phi) / (sqrt3 (3 - sin(phi)))   the paper's misprint
///   inner          6 c cos(phi) / (sqrt3 (3 + sin(phi)))
///   plane_strain   3 c / sqrt(9 + 12 tan^2(phi))
template <class Real>
HOST_DEVICE inline Real yield_cohesion_term(Real cohesion, Real phi, YieldFit fit) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  const Real sqrt3 = sqrt(Real(3));
  const Real s = sin(phi);
  switch (fit) {
    case YieldFit::outer:
    case YieldFit::paper:
      return 6 * cohesion * cos(phi) / (sqrt3 * (3 - s));
    case YieldFit::printed:
      return 6 * cohesion * s / (sqrt3 * (3 - s));
    case YieldFit::inner:
      return 6 * cohesion * cos(phi) / (sqrt3 * (3 + s));
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
