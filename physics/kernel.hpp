#pragma once

#include "physics/lane_math.hpp"

namespace thalweg {

/// Wendland's C2 kernel, support 2h (Wendland 1995; the paper's eq. 3), q = r/h in [0, 2]:
///   W(q)  = s (1 - q/2)^4 (2q + 1),            s = 21/(16 pi h^3) in 3-D, 7/(4 pi h^2) in 2-D
///   dW/dr = -5 s q (1 - q/2)^3 / h
/// so that grad W = F r with F = -5 s (1 - q/2)^3 / h^2: no division by r, finite at r = 0.
/// Both are coded on the closeness t = max(0, 1 - q/2), so that they vanish outside the support without a branch.
/// Real: type of the constants; L: a number or a pack of numbers.
template <int Dim, class Real>
struct WendlandC2 {
  Real half_inverse_h;   // 1/(2h) [1/m]
  Real value_factor;     // s [1/m^Dim]
  Real gradient_factor;  // -5 s / h^2 [1/m^(Dim+2)]

  /// h: smoothing length [m], > 0.
  HOST_DEVICE explicit WendlandC2(Real h) {
    constexpr double pi = 3.14159265358979323846;
    const double s =
        (Dim == 3) ? 21 / (16 * pi * double(h) * double(h) * double(h)) : 7 / (4 * pi * double(h) * double(h));
    half_inverse_h = Real(0.5 / double(h));
    value_factor = Real(s);
    gradient_factor = Real(-5 * s / (double(h) * double(h)));
  }

  /// Closeness t [-] of two points at a distance [m]: 1 at the same place, 0 outside the support.
  template <class L>
  HOST_DEVICE L closeness(const L& distance) const {
    return lane_max(L(1) - distance * L(half_inverse_h), L(0));
  }

  /// W [1/m^Dim] from the closeness t; q = 2 (1 - t), hence 2q + 1 = 5 - 4t.
  template <class L>
  HOST_DEVICE L value(const L& t) const {
    const L t2 = t * t;
    return L(value_factor) * t2 * t2 * (L(5) - L(4) * t);
  }

  /// F [1/m^(Dim+2)], grad W = F (x_a - x_b); F <= 0.
  template <class L>
  HOST_DEVICE L gradient(const L& t) const {
    return L(gradient_factor) * t * t * t;
  }
};

/// The closeness t of WendlandC2 in double precision, by a division by the support 2h [m]. closeness() multiplies by
/// 1/(2h), which is faster and rounds once more; this is for sums on the host that position particles to the last bit.
inline double closeness_by_support(double distance, double support) { return lane_max(1 - distance / support, 0.0); }

}  // namespace thalweg
