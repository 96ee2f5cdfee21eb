#pragma once

#include <cmath>

#include "physics/water/mixing_length.hpp"
#include "solver/models/mixing_length/arrays.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/velocity_gradient.hpp"
#include "solver/state/step_state.hpp"

// Eddy viscosity of the water (physics/water/mixing_length.hpp), and the forces it makes. It is found every few steps,
// and lies in the records' viscosity, times the density.
namespace thalweg {

/// Steps from one eddy viscosity to the next. In eight steps water at a twentieth of the sound speed goes a fifth of a
/// smoothing length.
inline constexpr int eddy_interval = 8;

/// Pair sweep: eddy viscosity of the water, from its velocity gradient over water neighbours alone. Walls and sediment do
/// not enter: with their velocity in the gradient a current is 3 % too slow.
template <int Dim>
struct EddyViscositySweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter, field::eddies>;
  using writes = Writes<field::eddies>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    GradientSum<Dim, L> velocity;
  };

  const Record* records;
  Eddies* eddies;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    sum.velocity.add(b.velocity - a.velocity, g, lane_select(is_water(b), b.volume * g.F, L(0.0F)));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Eddies& around = eddies[i];
    around.viscosity = 0;
    if (!is_water(records[i]) || records[i].volume == 0) return;
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const float* const u = records[i].velocity;
    around.viscosity =
        eddy_viscosity(mixing_length(around.wall_distance, around.depth), strain_rate<Dim>(gradient).magnitude,
                       std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
  }
};

/// Particle pass over the fluid: the eddies' dynamic viscosity into the records of water.
struct EddyViscosityPass {
  using reads = Reads<field::matter, field::eddies>;
  using writes = Writes<field::matter>;

  Record* records;
  const Eddies* eddies;
  float water_density;

  HOST_DEVICE void operator()(Index i) const {
    if (is_water(records[i])) records[i].viscosity = water_density * eddies[i].viscosity;
  }
};

template <int Dim, class Device>
void bring_eddy_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.for_each(p.fluid_count, EddyViscosityPass{p.record.data(), p.eddies.data(), scene.water_density});
}

/// Finds the eddy viscosity, if it is `due` or the step's number says so.
template <int Dim, class Device>
void find_eddy_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state, bool due) {
  on.for_each(1, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index) {
                state->finds_eddies = due || state->number % eddy_interval == 0 ? 1 : 0;
              }));
  const int* const before = on.skip_unless(&state->finds_eddies);
  const EddyViscositySweep<Dim> body{p.record.data(), p.eddies.data()};
  if (p.any_resting) {
    sweep(on, p, scene, p.pure_water(), body);
    sweep(on, p, scene, p.near_sediment(), body);
  } else {
    sweep(on, p, scene, p.all_fluid(), body);
  }
  bring_eddy_viscosity(on, p, scene);
  on.skip_unless(before);
}

/// Pair sweep: MomentumSweep, and between particles of water
///   rho_a du_a/dt += sum_b V_b (rho nu_a + rho nu_b) F u_ab
/// The mean of the two viscosities is arithmetic; with the harmonic one a current is 5 % off.
template <int Dim, bool lends = false>
struct EddyMomentumSweep {
  using neighbours = typename MomentumSweep<Dim, lends>::neighbours;
  using reads = typename MomentumSweep<Dim, lends>::reads;
  using writes = typename MomentumSweep<Dim, lends>::writes;
  static constexpr unsigned kernel = MomentumSweep<Dim, lends>::kernel;
  template <class L>
  using Sum = typename MomentumSweep<Dim, lends>::template Sum<L>;

  MomentumSweep<Dim, lends> momentum;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t entry,
                        Sum<L>& sum) const {
    momentum.pair(a, b, g, entry, sum);
    const L of_both = lane_select(is_water(a), lane_select(is_water(b), a.viscosity + b.viscosity, L(0.0F)), L(0.0F));
    const L drag = b.volume * g.F * of_both;
    const Vec<Dim, L> u = a.velocity - b.velocity;
    for (int k = 0; k < Dim; ++k) sum.force[k] += drag * u[k];
  }

  template <class Real>
  HOST_DEVICE void end(Index i, const Sum<Real>& sum) const {
    momentum.end(i, sum);
  }
};

/// The accelerations of compute_accelerations() with those of the eddies.
template <int Dim, class Device>
void compute_accelerations_with_eddies(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const MomentumSweep<Dim> momentum{p.record.data(), p.rates.data(), scene};
  const EddyMomentumSweep<Dim> body{momentum};
  if (!p.any_resting && !scene.has_drift) return sweep(on, p, scene, p.all_fluid(), body);
  sweep(on, p, scene, p.pure_water(), body);
  if (scene.has_drift) {
    const MomentumSweep<Dim, true> lending{p.record.data(), p.rates.data(), scene};
    sweep(on, p, scene, p.near_sediment(), EddyMomentumSweep<Dim, true>{lending});
  } else {
    sweep(on, p, scene, p.near_sediment(), body);
  }
}

}  // namespace thalweg
