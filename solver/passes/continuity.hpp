#pragma once

#include "physics/pair_terms.hpp"
#include "solver/passes/sweep.hpp"

namespace thalweg {

/// V_b psi_ab, the density diffusion of a pair of one phase; weight = V_b F. `same`: the two are of one phase.
template <int Dim, class LaneT, class Same, class L>
HOST_DEVICE inline L pair_diffusion(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, const L& weight,
                                    const Same& same, const Scene<Dim>& scene) {
  L g_dot_r = g.r[0] * L(scene.gravity[0]);
  for (int k = 1; k < Dim; ++k) g_dot_r = g_dot_r + g.r[k] * L(scene.gravity[k]);
  const L per_c2(1 / (scene.sound_speed * scene.sound_speed));
  return lane_select(same, density_diffusion(a.excess, b.excess, g_dot_r * per_c2, weight), L(0.0F));
}

/// Pair sweep over clusters of pure water: rate of the density excess, the paper's (6) in the volume form that is right
/// across a jump of density,
///   d(excess_a)/dt = (1 + excess_a) sum_b V_b u_ab.grad W + 2 delta h c sum_{b water} V_b psi_ab
/// with psi the density diffusion of pair_terms.hpp.
template <int Dim>
struct ContinuitySweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L compression;
    L diffusion;
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    sum.compression += weight * dot(a.velocity - b.velocity, g.r);
    sum.diffusion += pair_diffusion(a, b, g, weight, is_water(b), scene);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const { end(i, sum.compression, sum.diffusion); }

  HOST_DEVICE void end(Index i, float compression, float diffusion) const {
    if (is_resting(records[i])) return;
    rates[i].excess_rate = (1 + records[i].excess) * compression + scene.diffusion * diffusion;
  }
};

/// Density rates of the water that has no sediment in reach.
template <int Dim, class Device>
void compute_water_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  sweep(on, p, scene, p.pure_water(), ContinuitySweep<Dim>{p.record.data(), p.rates.data(), scene});
}

}  // namespace thalweg
