#pragma once

#include <cmath>

#include "physics/kernel.hpp"
#include "physics/vec.hpp"

// Fluid that sticks to a wall is at rest on the wall's surface. The wall's particles lie half a spacing and more behind
// that surface. A fluid particle at the distance d from the surface is therefore dragged as if the velocity went on
// linearly through the surface (Morris, Fox & Zhu 1997, J. Comput. Phys. 136, 214-226, eq. 22): the velocity difference
// to a wall particle at the depth e counts (d + e)/d times. Walls at rest add to the diagonal of the viscous system
// only, so that one factor f for each fluid particle suffices:
//   sum_w k_w (d + e_w)/d = f sum_w k_w,   f = l/d,   l = |sum_w k_w (x_a - x_w)| / sum_w k_w
// l [m] is the mean distance of the wall's particles along its normal. It tells d too, so that a table
// gives f from l.
namespace thalweg {

/// Sums over the walls in reach of a particle.
template <int Dim, class L>
struct WallDrag {
  L coefficients;        // k [kg/s]
  Vec<Dim, L> lever;     // k (x_a - x_w) [kg m/s]
  Vec<Dim, L> exchange;  // k (u_a - u_w) [N]

  template <class Sep>
  HOST_DEVICE void add(const L& k, const Sep& s, const Vec<Dim, L>& u) {
    coefficients += k;
    for (int c = 0; c < Dim; ++c) lever[c] += k * s.r[c];
    for (int c = 0; c < Dim; ++c) exchange[c] += k * u[c];
  }
};

/// Table of the excess f - 1 [-] over the mean distance l, for walls of lattice rows that begin half a spacing behind
/// their surface.
template <int Dim>
class NoSlip {
 public:
  NoSlip() = default;
  /// smoothing_length, spacing [m].
  NoSlip(double smoothing_length, double spacing) {
    const double nearest = 0.4 * spacing;  // closer than this, and between walls, f keeps its value from here
    const double farthest = 2 * smoothing_length - 0.6 * spacing;
    const double first = mean_distance(smoothing_length, spacing, nearest);
    const double step = (mean_distance(smoothing_length, spacing, farthest) - first) / intervals;
    first_ = static_cast<float>(first);
    per_length_ = static_cast<float>(1 / step);
    double d = nearest;
    for (int n = 0; n <= intervals; ++n) {
      const double l = first + n * step;
      for (const double upto = farthest; d < upto && mean_distance(smoothing_length, spacing, d) < l;) {
        d += 1e-3 * spacing;
      }
      excess_[n] = static_cast<float>(l / d - 1);
    }
  }

  /// f - 1 [-] for the sums of a particle; 0 without walls.
  [[nodiscard]] HOST_DEVICE float excess(const WallDrag<Dim, float>& walls) const {
    if (!(walls.coefficients > 0)) return 0;
    const float l = sqrtf(dot(walls.lever, walls.lever)) / walls.coefficients;
    const float at = fminf(fmaxf((l - first_) * per_length_, 0.0F), static_cast<float>(intervals));
    const int n = at < intervals - 1 ? static_cast<int>(at) : intervals - 1;
    return excess_[n] + (at - static_cast<float>(n)) * (excess_[n + 1] - excess_[n]);
  }

 private:
  static constexpr int intervals = 24;

  /// l of a particle at the distance d of a plane wall, both [m]: each row's weight is its kernel's integral.
  static double mean_distance(double smoothing_length, double spacing, double d) {
    const WendlandC2<Dim, double> kernel(smoothing_length);
    const double step = smoothing_length / 50;
    double weight = 0;
    double lever = 0;
    for (double z = d + spacing / 2; z < 2 * smoothing_length; z += spacing) {
      double row = 0;
      for (double y = step / 2; y < 2 * smoothing_length; y += step) {
        const double ring = Dim == 3 ? y : 1;
        row -= ring * kernel.gradient(kernel.closeness(std::sqrt(y * y + z * z)));
      }
      weight += row;
      lever += row * z;
    }
    return lever / weight;
  }

  float first_ = 0;
  float per_length_ = 0;
  float excess_[intervals + 1] = {};
};

}  // namespace thalweg
