#pragma once

#include "physics/pair_terms.hpp"
#include "physics/water/viscosity_switch.hpp"
#include "solver/passes/sweep.hpp"

namespace thalweg {

/// V_b psi_ab, the density diffusion of a pair of one phase; weight = V_b F. `same`: the two are of one phase.
template <int Dim, class LaneT, class Same, class L>
HOST_DEVICE inline L pair_diffusion(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, const L& weight,
                                    const Same& same, const Scene<Dim>& scene) {
  const L g_dot_r = gravity_dot(scene, g.r);
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

/// The share of the artificial viscosity that acts, from a velocity gradient [1/s].
template <int Dim>
HOST_DEVICE inline float acting_share(const float (&gradient)[Dim][Dim], const Scene<Dim>& scene) {
  float divergence = 0;
  float squares = 0;
  for (int i = 0; i < Dim; ++i) {
    divergence += gradient[i][i];
    for (int j = 0; j < Dim; ++j) squares += gradient[i][j] * gradient[i][j];
  }
  const float divergence2 = divergence * divergence;
  const float least = 1e-4F * scene.sound_speed / static_cast<float>(scene.smoothing_length);
  return viscosity_switch(divergence2, squares - divergence2 / Dim, least);
}

/// The same with the share of the artificial viscosity that acts in the next step. The sum of the velocity gradient is
/// not corrected: the share is a ratio of its parts.
template <int Dim>
struct ContinuityAndSwitchSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::rates, field::dissipation>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L diffusion;
    L gradient[Dim][Dim];  // G[i][j] = d u_i / d x_j
  };

  ContinuitySweep<Dim> continuity;
  float* dissipation;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    sum.diffusion += pair_diffusion(a, b, g, weight, is_water(b), continuity.scene);
    const Vec<Dim, L> u = b.velocity - a.velocity;
    for (int j = 0; j < Dim; ++j) {
      const L weighted = weight * g.r[j];
      for (int i = 0; i < Dim; ++i) sum.gradient[i][j] += weighted * u[i];
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    float compression = 0;
    for (int k = 0; k < Dim; ++k) compression -= sum.gradient[k][k];
    continuity.end(i, compression, sum.diffusion);
    dissipation[i] = acting_share<Dim>(sum.gradient, continuity.scene);
  }
};

/// Density rates of the water that has no sediment in reach.
template <int Dim, class Device>
void compute_water_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const ContinuitySweep<Dim> continuity{p.record.data(), p.rates.data(), scene};
  if (p.dissipations() == nullptr) {
    sweep(on, p, scene, p.pure_water(), continuity);
  } else {
    sweep(on, p, scene, p.pure_water(), ContinuityAndSwitchSweep<Dim>{continuity, p.dissipations()});
  }
}

}  // namespace thalweg
