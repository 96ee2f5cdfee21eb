#pragma once

#include "physics/no_slip.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/velocity_gradient.hpp"

namespace thalweg {

/// Pair sweep over clusters with sediment in reach: density rate and rate of strain. Walls count in the strain as if the
/// velocity went on through their surface (physics/no_slip.hpp), in the density rate with the velocity that they have.
template <int Dim>
struct ContinuityAndStrainSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::rates, field::sediment>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L diffusion;
    GradientSum<Dim, L> velocity;
    WallDrag<Dim, L> walls;
  };

  ContinuitySweep<Dim> continuity;
  Sediment* sediment;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    sum.diffusion += pair_diffusion(a, b, g, weight, same_phase(a, b), continuity.scene);
    add_velocity(b, b.velocity - a.velocity, g, weight, sum);
  }

  /// u = u_b - u_a, weight = V_b F.
  template <class LaneT, class L>
  HOST_DEVICE void add_velocity(const LaneT& b, const Vec<Dim, L>& u, const PairGeometry<Dim, L>& g, const L& weight,
                                Sum<L>& sum) const {
    sum.velocity.add(u, g, weight);
    sum.walls.add(lane_select(is_wall(b), -weight, L(0.0F)), g, u);
  }

  HOST_DEVICE void end(Index i, Sum<float> sum) const {
    float compression = 0;
    for (int k = 0; k < Dim; ++k) compression -= sum.velocity.gradient[k][k];
    continuity.end(i, compression, sum.diffusion);
    add_behind_walls(sum);
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const StrainRate strain = strain_rate<Dim>(gradient);
    sediment[i].strain_rate = strain.magnitude;
    sediment[i].lode_sine = strain.lode_sine;
  }

  /// The wall's part of the gradient counts f' times: (f' - 1) U (x) sum k r, U the mean velocity of a less its walls'.
  HOST_DEVICE void add_behind_walls(Sum<float>& sum) const {
    const WallDrag<Dim, float>& walls = sum.walls;
    if (!(walls.coefficients > 0)) return;
    const float more = continuity.scene.no_slip.excess_of_strain(walls) / walls.coefficients;
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) sum.velocity.gradient[i][j] -= more * walls.exchange[i] * walls.lever[j];
    }
  }
};

/// Density rates of all fluid. Pure water takes the light sweep; clusters with sediment in reach take the one with the
/// velocity gradient, and so does the resting sediment that moving neighbours may wake.
template <int Dim, class Device>
void compute_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  compute_water_density_rates(on, p, scene);
  if (!scene.has_sediment) return;
  const ContinuitySweep<Dim> water{p.record.data(), p.rates.data(), scene};
  const ContinuityAndStrainSweep<Dim> with_strain{water, p.sediment.data()};
  sweep(on, p, scene, p.near_sediment(), with_strain);
  if (p.any_resting) sweep(on, p, scene, p.rest_front(), with_strain);
}

}  // namespace thalweg
