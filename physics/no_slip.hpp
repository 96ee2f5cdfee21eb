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
//
// The rate of strain beside a wall asks for the same field behind its surface. In the sum of the velocity gradient
// (passes/velocity_gradient.hpp) a wall particle counts -V F (u_a - u_w) (d + e)/d (x) r. With k = -V F, r = r_n n on
// the mean along a plane wall, and walls that move as one, the wall's part of the sum counts f' times:
//   f' = sum_w k r_n^2/(d sum_w k r_n) = s/d
// s [m] is the mean distance once more, each wall particle with its lever as weight.
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

/// Sums over the rows of a plane wall: weights, and the distances of the rows times those.
struct WallRows {
  double weight = 0;
  double lever = 0;                                                           // sum of weight z
  double square = 0;                                                          // sum of weight z^2
  [[nodiscard]] double mean_distance() const { return lever / weight; }       // l
  [[nodiscard]] double distance_of_levers() const { return square / lever; }  // s
};

/// Tables of the excesses f - 1 and f' - 1 [-] over the mean distance l, for walls of lattice rows that begin half a
/// spacing behind their surface.
template <int Dim>
class NoSlip {
 public:
  NoSlip() = default;
  /// smoothing_length, spacing [m].
  NoSlip(double smoothing_length, double spacing) {
    const double nearest = 0.4 * spacing;  // closer than this, and between walls, f keeps its value from here
    const double farthest = 2 * smoothing_length - 0.6 * spacing;
    const auto rows = [&](double d) { return rows_behind(smoothing_length, spacing, d); };
    const double first = rows(nearest).mean_distance();
    const double step = (rows(farthest).mean_distance() - first) / intervals;
    first_ = static_cast<float>(first);
    per_length_ = static_cast<float>(1 / step);
    double d = nearest;
    for (int n = 0; n <= intervals; ++n) {
      const double l = first + n * step;
      while (d < farthest && rows(d).mean_distance() < l) d += 1e-3 * spacing;
      of_drag_[n] = static_cast<float>(l / d - 1);
      of_strain_[n] = static_cast<float>(rows(d).distance_of_levers() / d - 1);
    }
  }

  /// f - 1 [-], of the drag, for the sums of a particle; 0 without walls.
  [[nodiscard]] HOST_DEVICE float excess(const WallDrag<Dim, float>& walls) const { return look_up(of_drag_, walls); }

  /// f' - 1 [-], of the wall's part of the velocity gradient; the sums with k = -V F.
  [[nodiscard]] HOST_DEVICE float excess_of_strain(const WallDrag<Dim, float>& walls) const {
    return look_up(of_strain_, walls);
  }

 private:
  static constexpr int intervals = 24;

  HOST_DEVICE float look_up(const float (&table)[intervals + 1], const WallDrag<Dim, float>& walls) const {
    if (!(walls.coefficients > 0)) return 0;
    const float l = sqrtf(dot(walls.lever, walls.lever)) / walls.coefficients;
    const float at = fminf(fmaxf((l - first_) * per_length_, 0.0F), static_cast<float>(intervals));
    const int n = at < intervals - 1 ? static_cast<int>(at) : intervals - 1;
    return table[n] + (at - static_cast<float>(n)) * (table[n + 1] - table[n]);
  }

  /// The rows behind a plane wall's surface as a particle at the distance d sees them, both [m]: each row's weight is
  /// its kernel's integral.
  static WallRows rows_behind(double smoothing_length, double spacing, double d) {
    const WendlandC2<Dim, double> kernel(smoothing_length);
    const double step = smoothing_length / 50;
    WallRows sums;
    for (double z = d + spacing / 2; z < 2 * smoothing_length; z += spacing) {
      double row = 0;
      for (double y = step / 2; y < 2 * smoothing_length; y += step) {
        const double ring = Dim == 3 ? y : 1;
        row -= ring * kernel.gradient(kernel.closeness(std::sqrt(y * y + z * z)));
      }
      sums.weight += row;
      sums.lever += row * z;
      sums.square += row * z * z;
    }
    return sums;
  }

  float first_ = 0;
  float per_length_ = 0;
  float of_drag_[intervals + 1] = {};
  float of_strain_[intervals + 1] = {};
};

}  // namespace thalweg
