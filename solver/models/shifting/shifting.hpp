#pragma once

#include <cmath>

#include "solver/passes/integrate.hpp"
#include "solver/passes/sweep.hpp"
#include "solver/passes/velocity_gradient.hpp"

// Shifting: particles are moved a little, beside the motion of the fluid, from where they crowd to where they are
// sparse, as fast as the flow shears them out of order (after Lind et al. 2012, J. Comput. Phys. 231, 1499-1523, and
// Sun et al. 2017, Comput. Methods Appl. Mech. Eng. 315, 25-49):
//
//   dx_a = -C h^2 gdot_a dt s_a sum_b V_b [1 + e_ab (W_ab/W(dp))^4] grad W,   |dx_a| <= 0.1 dp
//
// summed over water, sediment and walls alike, so that a particle in order beside a wall stays there.
//   gdot_a  rate of strain of the water [1/s]: no shear, no shift; still water keeps its places
//   s_a     1 inside, 0 at a free surface, where the sum points outwards and would lift the level: a ramp on
//           -sum V F r^2/D, which is 1 in full surroundings and 0.6 in the row at the surface
//   e_ab    0.2 between pairs that nothing presses together: all where there is no gravity, and with gravity those under
//           tension, p_a + p_b < 0; else 0. It acts between nearest neighbours, and mends a lattice that tension tears.
//           Between pairs under weight it would push a sheared layer off its bed, by 3 % of the depth in five seconds.
//           Beside a wall it is 0: the wall's particles do not give way
// Water that has sediment in reach is shifted along the bed only, across sum V grad W over the sediment. Densities do not
// see shifts. So rows of water over a bed could have velocities that their shifts took back, 2 mm/s up in one row and down
// in the next, at no change of place; the bed took these velocities for room, and its moving layer sank by a fifth of a
// spacing in six seconds (docs/theory.md, Shifting).
// A shifted particle takes the velocity of the place where it comes to, u += grad u dx. Without it the shifts are a
// viscosity: a vortex at Re 1000, 32 particles a side, had an error of 4.2 % in place of 2.7. All together would gain
// momentum by that; their mean change of velocity is taken back, so that momentum stays to rounding. Masses stay.
//
// Densities do not see the shifts, nor what their diffusion does at a surface: with the time the volumes m/rho are no
// longer those that the particles take up, and a current of 0.1 m rose or sank by 3 mm in 90 s. So with gravity the
// densities follow the packing, as slowly as 2000 h/c:
//   dd = (f - 1) N dt/(2000 h/c),   f = -sum V F r^2/D,   where f > 0.95: with less there is a surface
namespace thalweg {

namespace field {
inline constexpr Field shift{"ShiftVelocity", quad_work};
}

namespace shifting {
inline constexpr float strength = 20;           // C [-]
inline constexpr float closest = 0.2F;          // e under tension [-]
inline constexpr float surface_from = 0.93F;    // of the ramp s [-]
inline constexpr float surface_width = 0.05F;   // [-]
inline constexpr float longest = 0.1F;          // of a shift, in spacings [-]
inline constexpr int interval = 4;              // steps from one shift to the next
inline constexpr float packing_time = 2000;     // of the density towards the packing, in h/c [-]
inline constexpr float packing_least = -0.05F;  // f - 1 where the packing is known [-]
}  // namespace shifting

/// Pair sweep over the fluid: the shift of each water particle, as the velocity [m/s] that takes it there within the
/// step, and the change of velocity that goes with it; 0 for others. `beds`: there is sediment.
template <int Dim, bool beds>
struct ShiftSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter, field::role>;
  using writes = Writes<field::shift, field::rates>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  template <class L>
  struct Sum {
    Vec<Dim, L> crowding;  // sum V grad W [1/m]
    Vec<Dim, L> closest;   // sum V e (W/W(dp))^4 grad W [1/m]
    L fullness;            // sum V F r^2 [-], -Dim inside
    L walls;               // sum of V W over walls [-]
    Vec<Dim, L> bed;       // sum V grad W over sediment [1/m]
    GradientSum<Dim, L> velocity;
  };

  Record* records;
  Rates* rates;  // the change of velocity [m/s] in place of the acceleration, which the next step finds anew
  const Role* roles;
  const StepState* state;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    const L ratio = g.W * L(scene.inverse_spacing_kernel);
    const L squared = ratio * ratio;
    const L torn = lane_select(a.pressure + b.pressure < L(scene.pressing), L(shifting::closest), L(0.0F));
    const L repelling = weight * torn * squared * squared;
    for (int k = 0; k < Dim; ++k) sum.crowding[k] += weight * g.r[k];
    for (int k = 0; k < Dim; ++k) sum.closest[k] += repelling * g.r[k];
    sum.fullness += weight * g.r2;
    sum.walls += lane_select(is_wall(b), b.volume * g.W, L(0.0F));
    if constexpr (beds) {
      const L of_bed = lane_select(is_sediment(b), weight, L(0.0F));
      for (int k = 0; k < Dim; ++k) sum.bed[k] += of_bed * g.r[k];
    }
    sum.velocity.add(b.velocity - a.velocity, g, lane_select(is_water(b), weight, L(0.0F)));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    for (int c = 0; c < 3; ++c) r.work[c] = rates[i].acceleration[c] = 0;
    r.work[3] = 0;
    const float inside = (-sum.fullness / Dim - shifting::surface_from) / shifting::surface_width;
    if (!(inside > 0) || !is_water(r) || r.volume == 0 || !is_integrated(roles, i)) return;
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const auto h = static_cast<float>(scene.smoothing_length);
    const float steps = static_cast<float>(scene.shifting_interval);
    const float packing = -sum.fullness / Dim - 1;
    if (scene.shifting_keeps_level && packing > shifting::packing_least) {
      r.work[3] =
          packing * steps * static_cast<float>(state->step.dt) * scene.sound_speed / (shifting::packing_time * h);
    }
    const float factor =
        shifting::strength * h * h * strain_rate<Dim>(gradient).magnitude * steps * (inside < 1 ? inside : 1);
    Vec<Dim, float> v{};
    for (int k = 0; k < Dim; ++k) v[k] = -factor * (sum.crowding[k] + (sum.walls > 0 ? 0 : sum.closest[k]));
    if constexpr (beds) {
      const float bed2 = dot(sum.bed, sum.bed);
      if (bed2 > 0) v = v - (dot(v, sum.bed) / bed2) * sum.bed;
    }
    const float v2 = dot(v, v);
    const auto most = static_cast<float>(shifting::longest * scene.spacing / state->step.dt);
    const float part = v2 > most * most ? most / sqrtf(v2) : 1;
    const auto dt = static_cast<float>(state->step.dt);
    for (int k = 0; k < Dim; ++k) {
      r.work[axis<Dim>(k)] = part * v[k];
      float change = 0;
      for (int j = 0; j < Dim; ++j) change += gradient[k][j] * part * v[j] * dt;
      rates[i].acceleration[axis<Dim>(k)] = change;
    }
  }
};

/// Momentum that the changes of velocity bring, and the mass of what is shifted.
struct ShiftMomentum {
  double momentum[3] = {};  // [kg m/s]
  double mass = 0;          // [kg]
};

/// Particle pass: what one particle adds to it.
struct ShiftMomentumPass {
  using reads = Reads<field::shift, field::rates, field::mass>;
  using writes = Writes<>;

  const Record* records;
  const Rates* rates;
  const float* mass;

  HOST_DEVICE static bool is_shifted(const Record& r) { return r.work[0] != 0 || r.work[1] != 0 || r.work[2] != 0; }

  HOST_DEVICE ShiftMomentum operator()(Index i) const {
    ShiftMomentum sum;
    if (!is_shifted(records[i])) return sum;
    sum.mass = double(mass[i]);
    for (int c = 0; c < 3; ++c) sum.momentum[c] = sum.mass * double(rates[i].acceleration[c]);
    return sum;
  }
};

/// Particle pass: moves the particles by their shifts, with the velocity of the place where they come to, less what all
/// together would gain in momentum.
template <int Dim>
struct ShiftPass {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::shift, field::rates>;
  using writes = Writes<field::place, field::flow, field::matter, field::position>;

  DriftPass<Dim> drift;
  const Rates* rates;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = drift.records[i];
    if (!ShiftMomentumPass::is_shifted(r)) return;
    for (int c = 0; c < 3; ++c) {
      r.velocity[c] += rates[i].acceleration[c] - static_cast<float>(state->shift_velocity[c]);
    }
    r.excess += r.work[3];
    drift.move(i, r.work);
  }
};

/// Shifts the water, if the step's number is a multiple of the interval.
template <int Dim, class Device>
void shift_particles(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  const int interval = scene.shifting_interval;
  on.for_each(1, declare<Reads<>, Writes<>>(
                     [=] HOST_DEVICE(Index) { state->shifts = state->number % interval == 0 ? state->moves : 0; }));
  const int* const before = on.skip_unless(&state->shifts);
  const auto find_shifts = [&]<bool beds>() {
    sweep(on, p, scene, p.all_fluid(), ShiftSweep<Dim, beds>{p.record.data(), p.rates.data(), p.roles(), state, scene});
  };
  if (scene.has_sediment) {
    find_shifts.template operator()<true>();
  } else {
    find_shifts.template operator()<false>();
  }
  on.reduce_then(
      p.fluid(), ShiftMomentum{}, ShiftMomentumPass{p.record.data(), p.rates.data(), p.mass.data()},
      [] HOST_DEVICE(ShiftMomentum a, const ShiftMomentum& b) {
        for (int c = 0; c < 3; ++c) a.momentum[c] += b.momentum[c];
        a.mass += b.mass;
        return a;
      },
      [=] HOST_DEVICE(const ShiftMomentum& sum) {
        for (int c = 0; c < 3; ++c) state->shift_velocity[c] = sum.mass > 0 ? sum.momentum[c] / sum.mass : 0;
      });
  on.for_each(p.fluid_count,
              ShiftPass<Dim>{{p.record.data(), p.position.data(), scene, state, 1.0}, p.rates.data(), state});
  on.skip_unless(before);
}

}  // namespace thalweg
