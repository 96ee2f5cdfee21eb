#pragma once

#include "physics/no_slip.hpp"
#include "solver/passes/sweep.hpp"

namespace thalweg {

/// Pair sweep over fluid near walls: the viscous force of the walls on water that sticks to their surface, added to its
/// acceleration,
///   rho_a du_a/dt = f sum_w V_w 2 mu_w F u_aw
/// the water's own viscous term (passes/momentum.hpp) with the factor f of physics/no_slip.hpp. Walls that move drag
/// with the velocity that they have. With it 0.125 h^2/nu is a stable step beside walls too: near one the diagonal of
/// the viscous sum is about 10 nu/h^2, in a corner 13, in the open 7, and twice its inverse bounds the step.
template <int Dim>
struct NoSlipSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    WallDrag<Dim, L> walls;  // per volume of a
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L k = b.volume * g.F * L(-2.0F * scene.water_viscosity);
    sum.walls.add(lane_select(is_wall(b), k, L(0.0F)), g, a.velocity - b.velocity);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (!is_water(r)) return;
    const float f = 1 + scene.no_slip.excess(sum.walls);
    const float per_density = f / (scene.water_density * (1 + r.excess));
    for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] -= per_density * sum.walls.exchange[k];
  }
};

template <int Dim, class Device>
void add_wall_drag(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  sweep(on, p, scene, p.near_walls(), NoSlipSweep<Dim>{p.record.data(), p.rates.data(), scene});
}

}  // namespace thalweg
