#pragma once

#include "physics/water/equation_of_state.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// Particle pass: p from the density excess by the phase's equation of state, volume from mass and density. Particles
/// at rest have theirs from extrapolate_to_resting.
template <int Dim>
struct EquationOfStatePass {
  Record* records;
  const float* mass;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (r.volume == 0 || is_resting(r)) return;
    r.pressure = tait_pressure(r.excess, scene.stiffness(r.phase));
    r.volume = mass[i] / (scene.density_at_rest(r.phase) * (1 + r.excess));
  }
};

template <int Dim, class Device>
void apply_equation_of_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.for_each(p.fluid_count, EquationOfStatePass<Dim>{p.record.data(), p.mass.data(), scene});
}

/// Pair sweep: pressure extrapolated from the moving fluid in reach, balanced for gravity (Adami, Hu & Adams 2012, J.
/// Comput. Phys. 231, 7057-7075, eq. 27):
///   p_w = sum_f [p_f + rho_f g.(x_w - x_f)] V_f W / sum_f V_f W,  not below zero: a wall does not pull.
template <int Dim>
struct ExtrapolatedPressureSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L weight;
    L pressure;
  };

  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& f, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L W = scene.kernel.value(scene.kernel.closeness(lane_sqrt(s.r2)));
    const L moving = lane_select(f.state > L(state_resting - 0.5F), L(0.0F), f.volume);
    const L weight = lane_select(f.phase > L(phase_wall + 0.5F), moving * W, L(0.0F));
    L g_dot_r = s.r[0] * L(scene.gravity[0]);
    for (int k = 1; k < Dim; ++k) g_dot_r = g_dot_r + s.r[k] * L(scene.gravity[k]);
    const L rho0 = lane_select(f.phase > L(phase_water + 0.5F), L(scene.sediment_density), L(scene.water_density));
    sum.weight += weight;
    sum.pressure += weight * (f.pressure + rho0 * (L(1.0F) + f.excess) * g_dot_r);
  }

  HOST_DEVICE static float pressure(const Sum<float>& sum) {
    const float p = sum.weight > 0 ? sum.pressure / sum.weight : 0;
    return p > 0 ? p : 0;
  }
};

/// The same over wall particles, which also take the share of sediment in the fluid they continue, at rest or not: a
/// bed does not end at a wall (models/states/bed_states.hpp).
template <int Dim>
struct WallPressureSweep : ExtrapolatedPressureSweep<Dim> {
  using Base = ExtrapolatedPressureSweep<Dim>;
  template <class L>
  struct Sum {
    typename Base::template Sum<L> pressure;
    L fluid;
    L sediment;
  };
  Record* records;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& f, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    Base::pair(a, f, s, entry, sum.pressure);
    const L weight = f.volume * this->scene.kernel.value(this->scene.kernel.closeness(lane_sqrt(s.r2)));
    sum.fluid += lane_select(f.phase > L(phase_wall + 0.5F), weight, L(0.0F));
    sum.sediment += lane_select(f.phase > L(phase_water + 0.5F), weight, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    records[i].pressure = this->pressure(sum.pressure);
    records[i].excess = sum.fluid > 0 ? sum.sediment / sum.fluid : 0;
  }
};

/// The same over sediment at rest: it takes the density of that pressure along, so that a particle which wakes goes on
/// with the pressure its neighbours have felt.
template <int Dim>
struct RestingPressureSweep : ExtrapolatedPressureSweep<Dim> {
  template <class L>
  using Sum = typename ExtrapolatedPressureSweep<Dim>::template Sum<L>;
  Record* records;
  const float* mass;

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    if (!is_resting(r) || !(sum.weight > 0)) return;
    r.pressure = this->pressure(sum);
    r.excess = tait_excess(r.pressure, this->scene.stiffness(r.phase));
    r.volume = mass[i] / (this->scene.density_at_rest(r.phase) * (1 + r.excess));
  }
};

/// The same where walls move: beside a wall with the acceleration a_w the fluid's pressure rises by rho (g - a_w) per
/// length (Adami et al., eq. 27), so that
///   p_w = [sum_f (p_f + rho_f g.r) V_f W - a_w . sum_f rho_f r V_f W] / sum_f V_f W,   r = x_w - x_f
template <int Dim>
struct MovingWallPressureSweep {
  using Fixed = WallPressureSweep<Dim>;
  static constexpr unsigned quads = Fixed::quads;
  template <class L>
  struct Sum {
    typename Fixed::template Sum<L> fixed;
    Vec<Dim, L> lever;  // sum of rho r V W
  };

  Fixed fixed;
  const Rates* rates;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& f, const Sep& s, std::size_t entry, Sum<L>& sum) const {
    const Scene<Dim>& scene = fixed.scene;
    const L before = sum.fixed.pressure.weight;
    fixed.pair(a, f, s, entry, sum.fixed);
    const L rho0 = lane_select(f.phase > L(phase_water + 0.5F), L(scene.sediment_density), L(scene.water_density));
    const L mass = (sum.fixed.pressure.weight - before) * rho0 * (L(1.0F) + f.excess);
    for (int k = 0; k < Dim; ++k) sum.lever[k] += mass * s.r[k];
  }

  HOST_DEVICE void end(Index i, Sum<float> sum) const {
    for (int k = 0; k < Dim; ++k) sum.fixed.pressure.pressure -= rates[i].acceleration[axis<Dim>(k)] * sum.lever[k];
    fixed.end(i, sum.fixed);
  }
};

template <int Dim, class Device>
void extrapolate_to_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  if (scene.has_moving_walls) {
    const WallPressureSweep<Dim> fixed{{scene}, p.record.data()};
    on.template sweep<Dim>(p.list(), p.walls_near_fluid(), p.record.data(), scene.lattice.quantum,
                           MovingWallPressureSweep<Dim>{fixed, p.rates.data()});
    return;
  }
  on.template sweep<Dim>(p.list(), p.walls_near_fluid(), p.record.data(), scene.lattice.quantum,
                         WallPressureSweep<Dim>{{scene}, p.record.data()});
}

template <int Dim, class Device>
void extrapolate_to_resting(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  for (const ClusterRange range : {p.shore(), p.part_resting()}) {
    on.template sweep<Dim>(p.list(), range, p.record.data(), scene.lattice.quantum,
                           RestingPressureSweep<Dim>{{scene}, p.record.data(), p.mass.data()});
  }
}

}  // namespace thalweg
