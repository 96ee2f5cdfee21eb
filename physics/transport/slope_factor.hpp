#pragma once

#include <cmath>

#include "physics/vec.hpp"

namespace thalweg {

/// Factor k [-] of a slope on the critical shear stress: tau_cr on the slope = k * tau_cr of a flat bed.
///
/// A grain of weight W under water on a plane with unit normal n is held by friction of coefficient t = tan(phi) and
/// pulled by the drag F_D along e and the lift eta F_D along n. It starts to slide when the tangential force equals t
/// times the normal one (the paper's (25)-(28)):
///   |F_D e + W_t|^2 = t^2 (W cos(gamma) - eta F_D)^2
/// gamma inclination of the plane, cz = e . (upward vertical), e . W_t = -W cz. With x = F_D/W and D = eta t:
///   (1 - D^2) x^2 + 2 b x - c = 0,   b = D t cos(gamma) - cz,   c = t^2 cos^2(gamma) - sin^2(gamma)
/// The positive root is x = c/(b + sqrt(b^2 + (1 - D^2) c)), the paper's (29), whose root sign is lost in print. Where
/// b < 0 the sum would cancel; the other of the two equal forms of the root is used there. A flat bed has
/// x = t/(1 + D) (30), hence
///   k = x (1 + D)/t   (31), (32)
/// The result equals that of Seminara, Solari & Parker 2002 and the quadratic of SPHERA with Delta = D.
///
/// Special cases: sin(phi - gamma)/sin(phi) down the slope and sin(phi + gamma)/sin(phi) up it, whatever eta; Lane's
/// cos(gamma) sqrt(1 - tan^2(gamma)/t^2) across it for eta = 0.
/// phi = 38 deg, eta = 0.85: 0.501927 down 20 deg, 1.377458 up, 0.7645225 across.
///
/// Limits:
///   k = 0 from gamma = phi on, where grains roll without any flow; 0 <= k <= 2 everywhere
///   D <= 0.99 by a smaller eta, since lift alone would raise a grain above; from phi = 49.6 deg on for eta = 0.85
///   flow straight at the bed, or none, has no direction and counts as flow across the slope (cz = 0)
///
/// normal: unit vector out of the bed; flow: velocity of the water over the bed in any unit, of which the part along
/// the bed counts; gravity: its unit direction; tan_phi > 0; lift_ratio eta = F_L/F_D >= 0, 0.85 in the paper.
template <int Dim, class Real>
HOST_DEVICE inline Real slope_factor(const Vec<Dim, Real>& normal, const Vec<Dim, Real>& flow,
                                     const Vec<Dim, Real>& gravity, Real tan_phi, Real lift_ratio) {
  using std::sqrt;
  const Real cos_slope = -dot(normal, gravity);
  const Vec<Dim, Real> pull = gravity + cos_slope * normal;  // of gravity along the bed, of length sin(gamma)
  const Real sin2_slope = dot(pull, pull);
  const Real c = tan_phi * tan_phi * cos_slope * cos_slope - sin2_slope;
  if (!(cos_slope > 0) || !(c > 0)) return 0;

  const Vec<Dim, Real> along = flow - dot(flow, normal) * normal;
  const Real speed = sqrt(dot(along, along));
  const Real rise = speed > 0 ? -dot(along, gravity) / speed : Real(0);

  const Real D = lift_ratio * tan_phi < Real(0.99) ? lift_ratio * tan_phi : Real(0.99);
  const Real b = D * tan_phi * cos_slope - rise;
  const Real root = sqrt(b * b + (1 - D * D) * c);
  const Real x = b > 0 ? c / (b + root) : (root - b) / (1 - D * D);
  const Real k = x * (1 + D) / tan_phi;
  return k < 2 ? k : Real(2);
}

}  // namespace thalweg
