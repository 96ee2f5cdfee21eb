#pragma once

#include "solver/models/bed/arrays.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/velocity_gradient.hpp"

namespace thalweg {

/// Pair sweep over clusters with sediment in reach: density rate and rate of strain.
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
  };

  ContinuitySweep<Dim> continuity;
  Sediment* sediment;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    sum.diffusion += pair_diffusion(a, b, g, weight, same_phase(a, b), continuity.scene);
    sum.velocity.add(b.velocity - a.velocity, g, weight);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    float compression = 0;
    for (int k = 0; k < Dim; ++k) compression -= sum.velocity.gradient[k][k];
    continuity.end(i, compression, sum.diffusion);
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const StrainRate strain = strain_rate<Dim>(gradient);
    sediment[i].strain_rate = strain.magnitude;
    sediment[i].lode_sine = strain.lode_sine;
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
