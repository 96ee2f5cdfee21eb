#pragma once

#include "solver/models/bed/strain.hpp"
#include "solver/models/seepage/arrays.hpp"
#include "solver/models/seepage/sets.hpp"

namespace thalweg {

namespace field {
/// The work quad during the density rates: the volume flux of water, the velocity of grains [m/s].
inline constexpr Field volume_flux{"VolumeFlux", quad_work};
}  // namespace field

/// Pair sweep: the volume flux at a water particle, q = n v_water + (1 - n) v_grains, into the work quad.
template <int Dim>
struct VolumeFluxSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::flow, field::matter, field::pores>;
  using writes = Writes<field::volume_flux>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L weight;
    Vec<Dim, L> velocity;
  };

  Record* records;
  const PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L value = b.volume * g.W;
    const L weight = lane_select(is_sediment(b), value, L(0.0F));
    sum.weight += weight;
    for (int k = 0; k < Dim; ++k) sum.velocity[k] += weight * b.velocity[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    if (!is_water(r) || !(sum.weight > 0)) return;
    const float n = pores[i].porosity;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      r.work[c] = n * r.velocity[c] + (1 - n) * sum.velocity[k] / sum.weight;
    }
  }
};

/// Pair sweep: the continuity sweep within each set, of water for the volume flux in place of its velocity:
///   water   d' = -(1 + d)/n div q        grains   d' = -(1 + d) div v, compression of the packing
/// The packing has no density diffusion. Its correction for gravity supposes the grains' whole weight in their pressure,
/// and would make them creep with 1 mm/s where seepage carries most of it; drag and friction damp them anyway.
template <int Dim>
struct MixtureContinuitySweep {
  using neighbours = Neighbours<field::place, field::matter, field::volume_flux>;
  using reads = Reads<field::matter, field::pores, field::rates>;
  using writes = Writes<field::rates, field::sediment, field::dissipation>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  using Sum = typename ContinuityAndStrainSweep<Dim, false>::template Sum<L>;

  ContinuityAndStrainSweep<Dim, false> own;
  const PoreState* pores;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    sum.diffusion += pair_diffusion(a, b, g, b.volume * g.F, is_water(a) & is_water(b), own.continuity.scene);
    const Vec<Dim, L> flux = b.work - a.work;
    const L weight = mixture::volume_seen(a, b) * g.F;
    sum.own += -weight * dot(flux, g.r);
    own.add_velocity(b, flux, g, weight, sum);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    own.end(i, sum);
    const bool grain = is_sediment(own.continuity.records[i]);
    if (!grain) own.continuity.rates[i].excess_rate /= pores[i].porosity;
  }
};

template <int Dim, class Device>
void compute_mixture_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  const PoreState* pores = p.pores.data();
  on.for_each(p.fluid_count, declare<Reads<field::flow>, Writes<field::volume_flux>>([=] HOST_DEVICE(Index i) {
                for (int c = 0; c < 3; ++c) records[i].work[c] = records[i].velocity[c];
              }));
  sweep(on, p, scene, p.near_sediment(), VolumeFluxSweep<Dim>{records, pores, scene});
  compute_water_density_rates(on, p, scene);
  const ContinuitySweep<Dim> continuity{records, p.rates.data(), scene};
  sweep(on, p, scene, p.near_sediment(),
        MixtureContinuitySweep<Dim>{{continuity, p.sediment.data(), p.dissipations()}, pores});
}

}  // namespace thalweg
