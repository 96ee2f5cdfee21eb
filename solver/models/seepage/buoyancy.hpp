#pragma once

#include "solver/models/seepage/arrays.hpp"
#include "solver/models/seepage/sets.hpp"
#include "solver/passes/momentum.hpp"

namespace thalweg {

namespace field {
/// The work quad between momentum and buoyancy: of water the force on its tile over the tile's volume, of grains
/// 1/(sum of T W over the water around).
inline constexpr Field tile_force{"TileForce", quad_work};
}  // namespace field

/// Pair sweep: the momentum sweep within each set. Leaves in the work quad what the buoyancy needs: of water the force
/// on its tile over the tile's volume, of grains 1/(sum of T W over the water around).
template <int Dim>
struct MixtureMomentumSweep {
  using neighbours = typename MomentumSweep<Dim>::neighbours;
  using reads = Reads<field::place, field::flow, field::matter, field::pores>;
  using writes = Writes<field::rates, field::tile_force>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    typename MomentumSweep<Dim>::template Sum<L> own;
    L water;
  };

  MomentumSweep<Dim> momentum;
  Record* records;
  const PoreState* pores;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    momentum.pair(a, mixture::seen_by(a, b, momentum.scene), g, entry, sum.own);
    const L weight = b.volume * g.W;
    sum.water += lane_select(is_water(b), weight, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    const Scene<Dim>& scene = momentum.scene;
    const bool grain = is_sediment(r);
    // Of a tile's volume, grains fill phi_0 and water n.
    const float density = grain ? scene.sediment_density * scene.seepage.solids_at_rest
                                : scene.water_density * (1 + r.excess) * pores[i].porosity;
    for (int c = 0; c < 3; ++c) r.work[c] = 0;
    for (int k = 0; k < Dim; ++k) {
      momentum.rates[i].acceleration[axis<Dim>(k)] = scene.gravity[k] + sum.own.force[k] / density;
      if (!grain) r.work[axis<Dim>(k)] = sum.own.force[k];
    }
    if (grain) r.work[0] = sum.water > 0 ? 1 / sum.water : 0;
  }
};

/// Pair sweep: of the force f_b on a tile of water, the grain a takes V_a T_b W_ab f_b/sum_b T_b W_ab, and the water as
/// much less: pair by pair, so that momentum stays. In a uniform mixture the water keeps its share n.
template <int Dim>
struct BuoyancySweep {
  using neighbours = Neighbours<field::place, field::matter, field::tile_force>;
  using reads = Reads<field::matter, field::pores, field::tile_force, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    Vec<Dim, L> of_water;
    L of_grains;
  };

  const Record* records;
  Rates* rates;
  const PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.W;
    const L of_water = lane_select(is_water(b), weight, L(0.0F));
    const L of_grain = lane_select(is_sediment(b), weight, L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.of_water[k] += of_water * b.work[k];
    sum.of_grains += of_grain * b.work[0];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (is_sediment(r)) {
      const float per_mass = r.work[0] / scene.sediment_density;
      for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] += per_mass * sum.of_water[k];
    } else {
      const float density = scene.water_density * (1 + r.excess) * pores[i].porosity;
      const float share = scene.seepage.solids_at_rest * sum.of_grains / density;
      for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] -= share * r.work[axis<Dim>(k)];
    }
  }
};

template <int Dim, class Device>
void compute_mixture_accelerations(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  const PoreState* pores = p.pores.data();
  const MomentumSweep<Dim> momentum{records, p.rates.data(), scene};
  sweep(on, p, scene, p.pure_water(), momentum);
  sweep(on, p, scene, p.near_sediment(), MixtureMomentumSweep<Dim>{momentum, records, pores});
  sweep(on, p, scene, p.near_sediment(), BuoyancySweep<Dim>{records, p.rates.data(), pores, scene});
}

}  // namespace thalweg
