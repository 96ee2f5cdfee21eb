#pragma once

#include "solver/passes/integrate.hpp"

// The integrator in two passes: the explicit midpoint rule, of second order in time also where velocities enter the
// accelerations (Monaghan 1994 and most SPH codes since), with two evaluations of accelerations and density rates a
// step where leapfrog has one. For comparison: in the scenes at hand it gains nothing (docs/speed-against-error.md).
//
//   half-way   u' = u + dt/2 (a + a_viscous of the last step),  x' = x + dt/2 u,  d' = d + dt/2 d_rate
//   whole      u+ = u + dt a(') and the viscous solve,  x+ = x + dt/2 (u + u+),   d+ = d + dt d_rate(')
namespace thalweg {

/// Where a particle was at the start of the step.
struct StepStart {
  Position position;
  float velocity[3];  // [m/s]
  float excess;       // [-]
};

/// Keeps the start of the step and goes half of the way.
template <int Dim, class Device>
void go_half_way(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                 typename Device::template Buffer<StepStart>& start) {
  start.resize(p.fluid_count);
  StepStart* kept = start.data();
  Record* records = p.record.data();
  Position* positions = p.position.data();
  const Rates* rates = p.rates.data();
  const Sediment* sediment = scene.has_sediment ? p.sediment.data() : nullptr;
  const DriftPass<Dim> half_drift{records, positions, scene, state, 0.5};
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    Record& r = records[i];
    kept[i] = {positions[i], {r.velocity[0], r.velocity[1], r.velocity[2]}, r.excess};
    if (is_resting(r)) return;
    half_drift(i);
    const auto half = static_cast<float>(state->step.dt / 2);
    for (int c = 0; c < 3; ++c) {
      const float viscous = sediment != nullptr ? sediment[i].viscous_acceleration[c] : 0;
      r.velocity[c] += half * (rates[i].acceleration[c] + viscous);
    }
    r.excess += half * rates[i].excess_rate;
  });
}

/// The velocities of the start again, at the places half-way.
template <class Device>
void take_back_velocities(Device& on, Particles<Device>& p, const typename Device::template Buffer<StepStart>& start) {
  const StepStart* kept = start.data();
  Record* records = p.record.data();
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].velocity[c] = kept[i].velocity[c];
  });
}

/// From the start of the step all the way, with the mean of the velocities before and after.
template <int Dim, class Device>
void go_all_the_way(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                    const typename Device::template Buffer<StepStart>& start) {
  const StepStart* kept = start.data();
  Record* records = p.record.data();
  Position* positions = p.position.data();
  const Rates* rates = p.rates.data();
  const DriftPass<Dim> whole_drift{records, positions, scene, state, 1};
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    Record& r = records[i];
    if (r.volume == 0 || is_resting(r)) return;
    const StepStart& from = kept[i];
    positions[i] = from.position;
    float after[3];
    for (int c = 0; c < 3; ++c) {
      after[c] = r.velocity[c];
      r.velocity[c] = (from.velocity[c] + after[c]) / 2;
    }
    whole_drift(i);
    for (int c = 0; c < 3; ++c) r.velocity[c] = after[c];
    r.excess = from.excess + static_cast<float>(state->step.dt) * rates[i].excess_rate;
  });
}

}  // namespace thalweg
