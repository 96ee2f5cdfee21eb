#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Mohr-Coulomb's criterion, the alternative to the cones of physics/sediment/drucker_prager.hpp: the strength depends on
// the kind of deformation too, by the Lode angle. The deviatoric stress of a flowing sediment is parallel to the rate
// of strain, so that the rate of strain's Lode angle is the stress's.
namespace thalweg {

/// Which criterion tells when the sediment yields.
enum class YieldCriterion { drucker_prager, mohr_coulomb };

/// Sine of three times the Lode angle [-], in [-1, 1]: sin(3 theta) = -(3 sqrt3/2) det(D)/(D:D/2)^(3/2) for a
/// deviatoric, symmetric rate of strain D [1/s] (stretching positive). -30 deg <= theta <= 30 deg:
///   +30 deg  compression along one axis, equal stretching across it (the triaxial test)
///     0      plane strain or simple shear
///   -30 deg  stretching along one axis
/// 0 for D = 0. determinant = det(D) [1/s^3], half_square = D:D/2 [1/s^2].
template <class Real>
HOST_DEVICE inline Real sine_of_three_lode_angles(Real determinant, Real half_square) {
  using std::sqrt;
  if (!(half_square > 0)) return 0;
  const Real s = Real(-2.59807621135331594) * (determinant / half_square) / sqrt(half_square);
  return s > 1 ? Real(1) : (s < -1 ? Real(-1) : s);
}

/// What the Mohr-Coulomb strength of plane strain, p sin(phi) + c cos(phi), is multiplied by at another Lode angle [-]:
///   sqrt(J2) [cos(theta) - sin(theta) sin(phi)/sqrt3] = p sin(phi) + c cos(phi)
/// Derivation: principal stresses (tension positive) -p + (2/sqrt3) sqrt(J2) {sin(theta + 120 deg), sin(theta),
/// sin(theta - 120 deg)} put into (s1 - s3)/2 = -(s1 + s3)/2 sin(phi) + c cos(phi).
/// 1 at theta = 0; at +-30 deg 2 sqrt3/(3 -+ sin(phi)): the outer and the inner cone of Drucker-Prager.
template <class Real>
HOST_DEVICE inline Real mohr_coulomb_factor(Real sine_of_three_lode_angles, Real sin_phi) {
  using std::asin;
  using std::cos;
  using std::sin;
  const Real theta = asin(sine_of_three_lode_angles) / 3;
  return 1 / (cos(theta) - sin(theta) * sin_phi * Real(0.577350269189625764));
}

/// Coefficient of p_eff in the Mohr-Coulomb criterion at a Lode angle [-], phi [rad].
/// phi = 38 deg: 0.894 at +30 deg, 0.616 at 0, 0.590 at -30 deg.
template <class Real>
HOST_DEVICE inline Real mohr_coulomb_pressure_coefficient(Real sine_of_three_lode_angles, Real phi) {
  using std::sin;
  return mohr_coulomb_factor(sine_of_three_lode_angles, sin(phi)) * sin(phi);
}

/// Yield stress without pressure [Pa] of the Mohr-Coulomb criterion for cohesion c [Pa].
template <class Real>
HOST_DEVICE inline Real mohr_coulomb_cohesion_term(Real sine_of_three_lode_angles, Real cohesion, Real phi) {
  using std::cos;
  using std::sin;
  return mohr_coulomb_factor(sine_of_three_lode_angles, sin(phi)) * cohesion * cos(phi);
}

}  // namespace thalweg
