#pragma once

#include <cmath>

#include "physics/lane_math.hpp"
#include "physics/water/von_karman.hpp"

// Suspended grains as a concentration C [-], the volume of grains in a volume of water with grains. They sink through the
// water at the settling velocity w [m/s] and are mixed by its eddies, of diffusivity D [m^2/s]. Water and grains change
// places, so that no volume moves.
namespace thalweg {

/// w/w_0, the settling velocity of grains among others over that of one alone, Richardson & Zaki 1954 (Trans. Inst.
/// Chem. Eng. 32, 35-53) for small grains:
///   (1 - C)^4.65
/// C within [0, 1]. 4.65 = 4 + 1/2 + 1/8 + 1/40; the last 40th is left out, which changes the result by 2 % at C = 0.55.
/// C = 0.1: 0.614; 0.3: 0.192.
template <class L>
HOST_DEVICE inline L hindered_share(const L& C) {
  const L x = lane_min(lane_max(L(1.0F) - C, L(0.0F)), L(1.0F));
  const L x2 = x * x;
  const L half = lane_sqrt(x);
  return x2 * x2 * half * lane_sqrt(lane_sqrt(half));
}

/// Logarithmic mean of two diffusivities, (D_a - D_b)/ln(D_a/D_b), by a third of the arithmetic and two thirds of the
/// geometric mean (Polya & Szego 1951). It is the one whose inverse is the mean of 1/D along a straight D: grains in
/// balance between two heights have the right ratio of concentrations however far apart these are.
/// Error: 0.2 % at a ratio of 5, 4 % at 50. Zero if one of them is zero and the other small.
template <class L>
HOST_DEVICE inline L mean_diffusivity(const L& D_a, const L& D_b) {
  return L(1.0F / 6.0F) * (D_a + D_b) + L(2.0F / 3.0F) * lane_sqrt(D_a * D_b);
}

/// Volume flux of grains from b to a over a distance, times the distance [m^2/s]:
///   D A(q) (C_b - C_a) + max(s, 0) C_b - max(-s, 0) C_a,   q = s/D,   A = max(0, (1 - 0.1 |q|)^5)
/// s [m^2/s] is the settling velocity times the height of b over a. It is the power law of Patankar 1980 (Numerical Heat
/// Transfer and Fluid Flow), which gives the exact balance C_b/C_a = exp(-q) to 0.5 % for every q, never a negative
/// concentration, and is antisymmetric to the last bit.
template <class L>
HOST_DEVICE inline L flux_of_grains(const L& C_a, const L& C_b, const L& s, const L& D) {
  const L zero(0.0F);
  const L q = lane_max(s, -s) * lane_reciprocal(lane_max(D, L(1e-30F)));
  const L A = lane_max(zero, L(1.0F) - L(0.1F) * q);
  const L A2 = A * A;
  return D * (A2 * A2 * A) * (C_b - C_a) + lane_max(s, zero) * C_b - lane_max(-s, zero) * C_a;
}

/// Volume flux of grains out of a bed [m/s] to water at the height z over it, negative if more settle:
///   J = w (C_r e^-q - C)/(1 - e^-q),   e^-q = (a s/z)^P,   P = w/(kappa u*)
/// the flux that does not change between the level a, where the concentration is C_r, and z, in eddies of the
/// diffusivity kappa u* z (1 - z/h) of a channel; s = 1 - z/h is their share of kappa u* z. Limits: without eddies
/// (u* -> 0) grains settle, J = -w C; in strong ones J = kappa u* (C_r - C)/ln(z/(a s)); J = 0 for Rouse's profile.
/// C_r, C [-]; w, u* [m/s]; z >= a > 0 [m], a much less than h.
template <class Real>
HOST_DEVICE inline Real flux_from_bed(Real C_r, Real C, Real w, Real friction_velocity, Real z, Real a, Real s = 1) {
  using std::exp;
  using std::expm1;
  using std::log;
  const Real settles = w * log((z > Real(1.01) * a ? z / a : Real(1.01)) / s);
  const Real mixing = von_karman<Real> * friction_velocity;
  const Real most = Real(80);  // e^-q is no number of single precision beyond
  if (!(settles < most * mixing)) return -w * C;
  const Real q = settles / mixing;
  return w * (C_r * exp(-q) - C) / -expm1(-q);
}

}  // namespace thalweg
