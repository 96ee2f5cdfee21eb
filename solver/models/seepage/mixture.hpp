#pragma once

#include <cmath>

#include "physics/seepage/ergun.hpp"
#include "solver/models/implicit/viscosity.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/momentum.hpp"

// The bed as a mixture: grains and pore water are two sets of particles in the same places (docs/theory.md, "Seepage:
// the bed as a mixture"). Each set fills space by itself: a particle's volume is its tile, its own matter with its
// share of the other set's. Within a set, and against walls, the sweeps are those of one fluid, the pressure of grains
// being what grain presses on grain. Between the sets act drag, in the implicit viscous solve, and buoyancy: of the
// force on a tile of water the grains in it take the share of their volume. Sums across the sets weigh and average
// only; a sum of grad W across them would hold each grain in the lattice of the water.
namespace thalweg {

/// What a particle of a mixture knows of the other set.
struct PoreState {
  float porosity;  // n [-], 1 away from grains
  float exchange;  // of water: drag coefficient of a pair over both tiles and W [kg m^dim/(m^3 s)]
};

/// Arrays of the mixture, kept between passes; empty without one.
template <class Device>
struct Mixture {
  typename Device::template Buffer<PoreState> pores;  // per particle
};

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

/// Energy of the compressed packing per mass of grains [J/kg]: (K/2) d^2 over the mass phi_0 rho_grain per volume; none
/// in tension.
template <int Dim>
HOST_DEVICE inline double skeleton_energy(double excess, const Scene<Dim>& scene) {
  const double d = excess > 0 ? excess : 0;
  const SeepageScene& law = scene.seepage;
  return 0.5 * double(law.skeleton_stiffness) * d * d / (double(law.solids_at_rest) * double(scene.sediment_density));
}

/// Volume of a neighbour as the set of `a` sees it: nothing if it is of the other set.
template <class LaneT>
HOST_DEVICE inline auto volume_seen(const LaneT& a, const LaneT& b) {
  using L = decltype(LaneT::volume);
  const L of_wall = lane_select(b.phase < L(phase_wall + 0.5F), b.volume, L(0.0F));
  return lane_select(a.phase == b.phase, b.volume, of_wall);
}

/// The neighbour as the set of `a` sees it; of a wall's two pressures the one that this set exerts (a wall keeps that
/// of the grains as its excess).
template <int Dim, class LaneT>
HOST_DEVICE inline LaneT seen_by(const LaneT& a, LaneT b, const Scene<Dim>& scene) {
  using L = decltype(LaneT::volume);
  const auto b_wall = b.phase < L(phase_wall + 0.5F);
  const auto a_grain = a.phase > L(phase_water + 0.5F);
  b.volume = volume_seen(a, b);
  b.pressure = lane_select(a_grain & b_wall, L(scene.seepage.skeleton_stiffness) * b.excess, b.pressure);
  return b;
}

}  // namespace mixture

/// Particle pass: pressures by the equations of state, and for now the volume a particle's own matter fills. Grains do
/// not compress; their excess is that of the packing, and carries load in compression only.
template <int Dim>
struct MixtureStatePass {
  Record* records;
  const float* mass;
  PoreState* pores;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    pores[i] = {1, 0};
    if (r.volume == 0) return;
    if (r.phase == phase_sediment) {
      r.volume = mass[i] / scene.sediment_density;
      r.pressure = r.excess > 0 ? scene.seepage.skeleton_stiffness * r.excess : 0;
    } else {
      r.volume = mass[i] / (scene.water_density * (1 + r.excess));
      r.pressure = tait_pressure(r.excess, scene.stiffness(r.phase));
    }
  }
};

/// Pair sweep: porosity from the kernel sums of both sets, n = S_w/(S_s + S_w), which is right along walls and surfaces
/// as well; coefficient of the drag from the slip w against the mean velocity of the grains around.
template <int Dim>
struct PoreSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L grains;               // S_s = sum V W of grains
    L water;                // S_w
    Vec<Dim, L> of_grains;  // sum over grains of V W u
  };

  const Record* records;
  PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * scene.kernel.value(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L of_grain = lane_select(b.phase > L(phase_water + 0.5F), weight, L(0.0F));
    sum.grains += of_grain;
    sum.water += lane_select(b.phase == L(phase_water), weight, L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.of_grains[k] += of_grain * b.velocity[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (!(sum.grains > 0) || r.volume == 0) return;
    PoreState& pore = pores[i];
    const float both = sum.grains + sum.water;
    const float n = sum.water / both;
    pore.porosity = n > mixture::least_porosity ? n : mixture::least_porosity;
    if (r.phase != phase_water) return;
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
  Record* records;
  const PoreState* pores;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (r.phase != phase_sediment) {
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
void apply_mixture_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Mixture<Device>& mix) {
  mix.pores.resize(p.count);
  Record* records = p.record.data();
  PoreState* pores = mix.pores.data();
  on.for_each(p.fluid_count, MixtureStatePass<Dim>{records, p.mass.data(), pores, scene});
  on.template sweep<Dim>(p.list(), p.near_sediment(), records, scene.lattice.quantum,
                         PoreSweep<Dim>{records, pores, scene});
  on.for_each(p.fluid_count, TilePass<Dim>{records, pores, scene});
}

/// Pair sweep over wall particles: pressure from the water in reach, compression of the packing from the grains in
/// reach (kept as the wall's excess), both balanced for gravity as in passes/pressure.hpp; neither below zero. A
/// packing at rest is compressed by g.r/c^2 as water is, by the choice of its stiffness.
template <int Dim>
struct MixtureWallSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L water;
    L pressure;
    L grains;
    L excess;
  };

  Record* records;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& f, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L weight = f.volume * scene.kernel.value(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L of_grain = lane_select(f.phase > L(phase_water + 0.5F), weight, L(0.0F));
    const L of_water = weight - of_grain;
    L g_dot_r = s.r[0] * L(scene.gravity[0]);
    for (int k = 1; k < Dim; ++k) g_dot_r = g_dot_r + s.r[k] * L(scene.gravity[k]);
    sum.water += of_water;
    sum.pressure += of_water * (f.pressure + L(scene.water_density) * (L(1.0F) + f.excess) * g_dot_r);
    sum.grains += of_grain;
    sum.excess += of_grain * (f.excess + L(1 / (scene.sound_speed * scene.sound_speed)) * g_dot_r);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const float pressure = sum.water > 0 ? sum.pressure / sum.water : 0;
    const float excess = sum.grains > 0 ? sum.excess / sum.grains : 0;
    records[i].pressure = pressure > 0 ? pressure : 0;
    records[i].excess = excess > 0 ? excess : 0;
  }
};

template <int Dim, class Device>
void extrapolate_mixture_to_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.template sweep<Dim>(p.list(), p.walls_near_fluid(), p.record.data(), scene.lattice.quantum,
                         MixtureWallSweep<Dim>{p.record.data(), scene});
}

/// Pair sweep: the momentum sweep within each set. Leaves in the work quad what the buoyancy needs: of water the force
/// on its tile over the tile's volume, of grains 1/(sum of T W over the water around).
template <int Dim, bool wall_friction>
struct MixtureMomentumSweep {
  static constexpr unsigned quads = MomentumSweep<Dim, wall_friction>::quads;
  template <class L>
  struct Sum {
    typename MomentumSweep<Dim, wall_friction>::template Sum<L> own;
    L water;
  };

  MomentumSweep<Dim, wall_friction> momentum;
  Record* records;
  const PoreState* pores;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    const WendlandC2<Dim, float>& kernel = momentum.scene.kernel;
    momentum.pair(a, mixture::seen_by(a, b, momentum.scene), s, entry, sum.own);
    const L weight = b.volume * kernel.value(kernel.closeness(lane_sqrt(s.r2)));
    sum.water += lane_select(b.phase == L(phase_water), weight, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    const Scene<Dim>& scene = momentum.scene;
    const bool grain = r.phase == phase_sediment;
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
  static constexpr unsigned quads = quad_place | quad_matter | quad_work;
  template <class L>
  struct Sum {
    Vec<Dim, L> of_water;
    L of_grains;
  };

  const Record* records;
  Rates* rates;
  const PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * scene.kernel.value(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L of_water = lane_select(b.phase == L(phase_water), weight, L(0.0F));
    const L of_grain = lane_select(b.phase > L(phase_water + 0.5F), weight, L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.of_water[k] += of_water * b.work[k];
    sum.of_grains += of_grain * b.work[0];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (r.phase == phase_sediment) {
      const float per_mass = r.work[0] / scene.sediment_density;
      for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] += per_mass * sum.of_water[k];
    } else {
      const float density = scene.water_density * (1 + r.excess) * pores[i].porosity;
      const float share = scene.seepage.solids_at_rest * sum.of_grains / density;
      for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] -= share * r.work[axis<Dim>(k)];
    }
  }
};

template <int Dim, bool wall_friction, class Device>
void compute_mixture_accelerations(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                   const Mixture<Device>& mix) {
  Record* records = p.record.data();
  const PoreState* pores = mix.pores.data();
  const auto sweep = [&](ClusterRange range, const auto& body) {
    on.template sweep<Dim>(p.list(), range, records, scene.lattice.quantum, body);
  };
  const MomentumSweep<Dim, wall_friction> momentum{records, p.rates.data(), scene};
  sweep(p.pure_water(), momentum);
  sweep(p.near_sediment(), MixtureMomentumSweep<Dim, wall_friction>{momentum, records, pores});
  sweep(p.near_sediment(), BuoyancySweep<Dim>{records, p.rates.data(), pores, scene});
}

template <int Dim, class Device>
void compute_mixture_accelerations(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                   const Mixture<Device>& mix) {
  if (scene.wall_friction) {
    compute_mixture_accelerations<Dim, true>(on, p, scene, mix);
  } else {
    compute_mixture_accelerations<Dim, false>(on, p, scene, mix);
  }
}

/// What couples the velocities of two particles of a mixture: within the grains and against walls their viscosity,
/// between grains and water the drag T_a T_b C W with the water's C, which lies in the work quad until the solve needs
/// it.
template <int Dim>
struct MixtureCoupling {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter | quad_work;
  static constexpr bool needs_stored = true;  // the iteration writes over the work quad
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE L coefficient(const LaneT& a, const LaneT& b, const Vec<Dim, L>&, const L& closeness) const {
    const auto a_grain = a.phase > L(phase_water + 0.5F);
    const auto b_grain = b.phase > L(phase_water + 0.5F);
    const auto b_wall = b.phase < L(phase_wall + 0.5F);
    const L eta = a.viscosity + lane_select(b_wall, a.viscosity, b.viscosity);
    const L viscous = viscous_coefficient(a.volume, b.volume, eta, scene.kernel.gradient(closeness));
    const L of_water = lane_select(a_grain, b.work[0], a.work[0]);
    const L drag = a.volume * b.volume * of_water * scene.kernel.value(closeness);
    const L of_grain = lane_select(b.phase == L(phase_water), drag, viscous);
    return lane_select(a_grain, of_grain, lane_select(b_grain, drag, L(0.0F)));
  }
};

/// Brings what MixtureCoupling reads to the records.
template <int Dim, class Device>
void prepare_mixture_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const Mixture<Device>& mix) {
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const PoreState* pores = mix.pores.data();
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    Record& r = records[i];
    r.work[0] = pores[i].exchange;
    if (r.phase != phase_sediment || !mixture::is_loose(pores[i].porosity, scene)) return;
    // What lies above loose grains is carried by the water, not by them: they have no strength.
    sediment[i].yield_stress = 0;
    r.viscosity = scene.sediment.consistency;
  });
}

/// Pair sweep: the volume flux at a water particle, q = n v_water + (1 - n) v_grains, into the work quad.
template <int Dim>
struct VolumeFluxSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L weight;
    Vec<Dim, L> velocity;
  };

  Record* records;
  const PoreState* pores;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L value = b.volume * scene.kernel.value(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L weight = lane_select(b.phase > L(phase_water + 0.5F), value, L(0.0F));
    sum.weight += weight;
    for (int k = 0; k < Dim; ++k) sum.velocity[k] += weight * b.velocity[k];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    if (r.phase != phase_water || !(sum.weight > 0)) return;
    const float n = pores[i].porosity;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      r.work[c] = n * r.velocity[c] + (1 - n) * sum.velocity[k] / sum.weight;
    }
  }
};

/// Pair sweep: the continuity sweep within each set, of water for the volume flux in place of its velocity:
///   water   d' = -(1 + d)/n div q        grains   d' = -(1 + d) div v, compression of the packing
template <int Dim>
struct MixtureContinuitySweep {
  static constexpr unsigned quads = quad_place | quad_matter | quad_work;
  template <class L>
  using Sum = typename ContinuityAndStrainSweep<Dim>::template Sum<L>;

  ContinuityAndStrainSweep<Dim> own;
  const PoreState* pores;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const Scene<Dim>& scene = own.continuity.scene;
    const L F = scene.kernel.gradient(scene.kernel.closeness(lane_sqrt(s.r2)));
    sum.diffusion += own.continuity.diffusion(a, b, s, b.volume * F);
    own.add_gradients(b.work - a.work, s, mixture::volume_seen(a, b) * F, sum);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    own.end(i, sum);
    const bool grain = own.continuity.records[i].phase == phase_sediment;
    if (!grain) own.continuity.rates[i].excess_rate /= pores[i].porosity;
  }
};

template <int Dim, class Device>
void compute_mixture_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                   const Mixture<Device>& mix) {
  Record* records = p.record.data();
  const PoreState* pores = mix.pores.data();
  const auto sweep = [&](ClusterRange range, const auto& body) {
    on.template sweep<Dim>(p.list(), range, records, scene.lattice.quantum, body);
  };
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].work[c] = records[i].velocity[c];
  });
  sweep(p.near_sediment(), VolumeFluxSweep<Dim>{records, pores, scene});
  const ContinuitySweep<Dim> continuity{records, p.rates.data(), scene};
  sweep(p.pure_water(), continuity);
  sweep(p.near_sediment(), MixtureContinuitySweep<Dim>{{continuity, p.sediment.data()}, pores});
}

}  // namespace thalweg
