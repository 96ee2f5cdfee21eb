#pragma once

#include "physics/water/equation_of_state.hpp"
#include "solver/passes/sweep.hpp"

namespace thalweg {

/// Particle pass: p from the density excess by the phase's equation of state, and from its last rate by the acoustic
/// damper; volume from mass and density. Particles at rest get theirs from their neighbours (models/rest/resting_pressure.hpp).
template <int Dim>
struct EquationOfStatePass {
  using reads = Reads<field::place, field::matter, field::mass, field::rates, field::dissipation>;
  using writes = Writes<field::place, field::flow, field::matter>;

  Record* records;
  const float* mass;
  const Rates* rates;
  const float* dissipation;  // nullptr where all of the artificial viscosity acts
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    r.dissipation = dissipation != nullptr ? dissipation[i] : 1;
    if (r.volume == 0 || is_resting(r)) return;
    const float rho0 = scene.density_at_rest(r.kind);
    r.pressure = tait_pressure(r.excess, scene.stiffness(r.kind)) +
                 damper_pressure(rho0, scene.acoustic_damping, rates[i].excess_rate);
    r.volume = mass[i] / (rho0 * (1 + r.excess));
  }
};

template <int Dim, class Device>
void apply_equation_of_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.for_each(p.fluid_count,
              EquationOfStatePass<Dim>{p.record.data(), p.mass.data(), p.rates.data(), p.dissipations(), scene});
}

/// Pair sum: pressure extrapolated from the moving fluid in reach, balanced for gravity (Adami, Hu & Adams 2012, J.
/// Comput. Phys. 231, 7057-7075, eq. 27):
///   p_w = sum_f [p_f + rho_f g.(x_w - x_f)] V_f W / sum_f V_f W,  not below zero: a wall does not pull.
template <int Dim>
struct ExtrapolatedPressureSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  static constexpr unsigned kernel = kernel_value;
  template <class L>
  struct Sum {
    L weight;
    L pressure;
  };

  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& f, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L moving = lane_select(is_resting(f), L(0.0F), f.volume);
    const L weight = lane_select(is_wall(f), L(0.0F), moving * g.W);
    const L g_dot_r = gravity_dot(scene, g.r);
    const L rho0 = lane_select(is_sediment(f), L(scene.sediment_density), L(scene.water_density));
    sum.weight += weight;
    sum.pressure += weight * (f.pressure + rho0 * (L(1.0F) + f.excess) * g_dot_r);
  }

  HOST_DEVICE static float pressure(const Sum<float>& sum) {
    const float p = sum.weight > 0 ? sum.pressure / sum.weight : 0;
    return p > 0 ? p : 0;
  }
};

/// The same over wall particles, which also take the share of sediment in the fluid they continue, at rest or not: a
/// bed does not end at a wall (models/states).
template <int Dim>
struct WallPressureSweep : ExtrapolatedPressureSweep<Dim> {
  using Base = ExtrapolatedPressureSweep<Dim>;
  using reads = Reads<>;
  using writes = Writes<field::flow, field::matter>;
  template <class L>
  struct Sum {
    typename Base::template Sum<L> pressure;
    L fluid;
    L sediment;
  };
  Record* records;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& f, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    Base::pair(a, f, g, entry, sum.pressure);
    const L weight = f.volume * g.W;
    sum.fluid += lane_select(is_wall(f), L(0.0F), weight);
    sum.sediment += lane_select(is_sediment(f), weight, L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    records[i].pressure = this->pressure(sum.pressure);
    records[i].excess = sum.fluid > 0 ? sum.sediment / sum.fluid : 0;
  }
};

/// Pressure of walls at rest.
template <int Dim, class Device>
void extrapolate_to_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  sweep(on, p, scene, p.walls_near_fluid(), WallPressureSweep<Dim>{{scene}, p.record.data()});
}

}  // namespace thalweg
