#pragma once

#include <cmath>

#include "physics/seepage/ergun.hpp"
#include "physics/water/equation_of_state.hpp"
#include "solver/models/seepage/arrays.hpp"
#include "solver/passes/sweep.hpp"

// The bed as a mixture: grains and pore water are two sets of particles in the same places (docs/theory.md, "Seepage:
// the bed as a mixture"). Each set fills space by itself: a particle's volume is its tile, its own matter with its
// share of the other set's. Within a set, and against walls, the sweeps are those of one fluid, the pressure of grains
// being what grain presses on grain. Between the sets act drag, in the implicit viscous solve, and buoyancy: of the
// force on a tile of water the grains in it take the share of their volume. Sums across the sets weigh and average
// only; a sum of grad W across them would hold each grain in the lattice of the water.
namespace thalweg {

namespace mixture {

/// Grains are loose, and do not press on each other, while they fill less than this share of their packing's space. The
/// top row of a bed on its lattice has 0.75.
inline constexpr float loose = 0.7F;
/// Drag laws are not used below this porosity.
inline constexpr float least_porosity = 0.2F;

template <int Dim>
HOST_DEVICE inline bool is_loose(float porosity, const Scene<Dim>& scene) {
  return 1 - porosity < loose * scene.seepage.solids_at_rest;
}

}  // namespace mixture

/// Particle pass: pressures by the equations of state, and for now the volume a particle's own matter fills. Grains do
/// not compress; their excess is that of the packing, and carries load in compression only.
template <int Dim>
struct MixtureStatePass {
  using reads = Reads<field::place, field::matter, field::mass, field::rates, field::dissipation>;
  using writes = Writes<field::place, field::flow, field::matter, field::pores>;

  Record* records;
  const float* mass;
  const Rates* rates;
  const float* dissipation;  // nullptr where all of the artificial viscosity acts
  PoreState* pores;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    pores[i] = {1, 0};
    r.dissipation = dissipation != nullptr ? dissipation[i] : 1;
    if (r.volume == 0) return;
    if (is_sediment(r)) {
      r.volume = mass[i] / scene.sediment_density;
      const float damper = damper_pressure(scene.sediment_density * scene.seepage.solids_at_rest,
                                           scene.acoustic_damping, rates[i].excess_rate);
      const float pressure = scene.seepage.skeleton_stiffness * r.excess + damper;
      r.pressure = r.excess > 0 && pressure > 0 ? pressure : 0;
    } else {
      r.volume = mass[i] / (scene.water_density * (1 + r.excess));
      r.pressure = tait_pressure(r.excess, scene.stiffness(r.kind)) +
                   damper_pressure(scene.water_density, scene.acoustic_damping, rates[i].excess_rate);
    }
  }
};

/// Pair sweep: porosity from the kernel sums of both sets, n = S_w/(S_s + S_w), which is right along walls and surfaces
/// as well; coefficient of the drag from the slip w against the mean velocity of the grains around.
template <int Dim>
struct PoreSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::pores>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L grains;               // S_s = sum V W of grains
    L water;                // S_w
    Vec<Dim, L> of_grains;  // sum over grains of V W u
  };

  const Record* records;
  PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.W;
    const L of_grain = lane_select(is_sediment(b), weight, L(0.0F));
    sum.grains += of_grain;
    sum.water += lane_select(is_water(b), weight, L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.of_grains[k] += of_grain * b.velocity[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (!(sum.grains > 0) || r.volume == 0) return;
    PoreState& pore = pores[i];
    const float both = sum.grains + sum.water;
    const float n = sum.water / both;
    pore.porosity = n > mixture::least_porosity ? n : mixture::least_porosity;
    if (!is_water(r)) return;
    float slip2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const float w = r.velocity[axis<Dim>(k)] - sum.of_grains[k] / sum.grains;
      slip2 += w * w;
    }
    // Over tiles T = V/n and V_grain/phi_0: summed over the grains around, T C S_s/phi_0 = T beta.
    const float per_solids =
        grain_drag(n, scene.seepage.grain_diameter, sqrtf(slip2), scene.water_viscosity, scene.water_density);
    pore.exchange = per_solids * scene.seepage.solids_at_rest / both;
  }
};

/// Particle pass: volumes become tiles; loose grains forget their packing.
template <int Dim>
struct TilePass {
  using reads = Reads<field::place, field::matter, field::pores>;
  using writes = Writes<field::place, field::flow, field::matter>;

  Record* records;
  const PoreState* pores;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (!is_sediment(r)) {
      r.volume /= pores[i].porosity;
      return;
    }
    r.volume /= scene.seepage.solids_at_rest;
    const float loosest = mixture::loose - 1;
    if (r.excess >= loosest && !mixture::is_loose(pores[i].porosity, scene)) return;
    r.excess = loosest;
    r.pressure = 0;
  }
};

template <int Dim, class Device>
void apply_mixture_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  p.pores.resize(p.count);
  Record* records = p.record.data();
  PoreState* pores = p.pores.data();
  on.for_each(p.fluid_count,
              MixtureStatePass<Dim>{records, p.mass.data(), p.rates.data(), p.dissipations(), pores, scene});
  sweep(on, p, scene, p.near_sediment(), PoreSweep<Dim>{records, pores, scene});
  on.for_each(p.fluid_count, TilePass<Dim>{records, pores, scene});
}

}  // namespace thalweg
