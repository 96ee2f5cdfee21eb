#pragma once

#include "solver/passes/pressure.hpp"

namespace thalweg {

/// Pair sweep over walls that may move: beside a wall with the acceleration a_w the fluid's pressure rises by
/// rho (g - a_w) per length (Adami et al., eq. 27), so that
///   p_w = [sum_f (p_f + rho_f g.r) V_f W - a_w . sum_f rho_f r V_f W] / sum_f V_f W,   r = x_w - x_f
template <int Dim>
struct MovingWallPressureSweep {
  using Fixed = WallPressureSweep<Dim>;
  using neighbours = typename Fixed::neighbours;
  using reads = Reads<field::rates>;
  using writes = typename Fixed::writes;
  static constexpr unsigned kernel = Fixed::kernel;
  template <class L>
  struct Sum {
    typename Fixed::template Sum<L> fixed;
    Vec<Dim, L> lever;  // sum of rho r V W
  };

  Fixed fixed;
  const Rates* rates;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& f, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    const Scene<Dim>& scene = fixed.scene;
    const L before = sum.fixed.pressure.weight;
    fixed.pair(a, f, g, entry, sum.fixed);
    const L rho0 = lane_select(is_sediment(f), L(scene.sediment_density), L(scene.water_density));
    const L mass = (sum.fixed.pressure.weight - before) * rho0 * (L(1.0F) + f.excess);
    for (int k = 0; k < Dim; ++k) sum.lever[k] += mass * g.r[k];
  }

  HOST_DEVICE void end(Index i, Sum<float> sum) const {
    for (int k = 0; k < Dim; ++k) sum.fixed.pressure.pressure -= rates[i].acceleration[axis<Dim>(k)] * sum.lever[k];
    fixed.end(i, sum.fixed);
  }
};

template <int Dim, class Device>
void extrapolate_to_moving_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const WallPressureSweep<Dim> fixed{{scene}, p.record.data()};
  sweep(on, p, scene, p.walls_near_fluid(), MovingWallPressureSweep<Dim>{fixed, p.rates.data()});
}

}  // namespace thalweg
