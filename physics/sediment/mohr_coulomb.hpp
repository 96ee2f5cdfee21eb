#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Mohr-Coulomb's criterion, the alternative to the cones of drucker_prager.hpp. The strength depends also on the kind
// of deformation, which the Lode angle theta tells. The deviatoric stress of a flowing sediment is parallel to the rate
// of strain, so that both have the same Lode angle.
namespace thalweg {

/// The criterion by which the sediment yields.
enum class YieldCriterion { drucker_prager, mohr_coulomb };

/// Sine of three times the Lode angle [-], in [-1, 1], of a deviatoric, symmetric rate of strain D [1/s] (stretching
/// positive):
///   sin(3 theta) = -(3 sqrt3/2) det(D)/(D:D/2)^(3/2),   0 for D = 0
/// -30 deg <= theta <= 30 deg:
///   +30 deg   compression along one axis, equal stretching across it (the triaxial test)
///     0 deg   plane strain or simple shear
///   -30 deg   stretching along one axis
/// determinant = det(D) [1/s^3], half_square = D:D/2 [1/s^2].
template <class Real>
HOST_DEVICE inline Real sine_of_three_lode_angles(Real determinant, Real half_square) {
  using std::sqrt;
  if (!(half_square > 0)) return 0;
  const Real s = Real(-2.59807621135331594) * (determinant / half_square) / sqrt(half_square);
  return s > 1 ? Real(1) : (s < -1 ? Real(-1) : s);
}

/// Factor [-] on the strength of plane strain, p sin(phi) + c cos(phi), at another Lode angle theta. From
///   sqrt(J2) [cos(theta) - sin(theta) sin(phi)/sqrt3] = p sin(phi) + c cos(phi)
/// it is 1/[cos(theta) - sin(theta) sin(phi)/sqrt3].
/// Derivation: the principal stresses (tension positive)
///   -p + (2/sqrt3) sqrt(J2) {sin(theta + 120 deg), sin(theta), sin(theta - 120 deg)}
/// put into Mohr-Coulomb's (s1 - s3)/2 = -(s1 + s3)/2 sin(phi) + c cos(phi).
/// Limits: 1 at theta = 0; 2 sqrt3/(3 - sin(phi)) at +30 deg and 2 sqrt3/(3 + sin(phi)) at -30 deg, the outer and the
/// inner cone of Drucker-Prager.
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
