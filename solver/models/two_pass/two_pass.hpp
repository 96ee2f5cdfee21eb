#pragma once

#include "solver/models/bed/arrays.hpp"
#include "solver/passes/integrate.hpp"

// The integrator in two passes: the explicit midpoint rule, of second order in time also where velocities enter the
// accelerations (Monaghan 1994 and most SPH codes since), with two evaluations of accelerations and density rates a
// step where leapfrog has one. For comparison: in the scenes at hand it gains nothing (docs/speed-against-error.md).
//
//   half-way   u' = u + dt/2 (a + a_viscous of the last step),  x' = x + dt/2 u,  d' = d + dt/2 d_rate
//   whole      u+ = u + dt a(') and the viscous solve,  x+ = x + dt/2 (u + u+),   d+ = d + dt d_rate(')
namespace thalweg {

/// A particle at the start of the step.
struct StepStart {
  Position position;
  float velocity[3];  // [m/s]
  float excess;       // [-]
};

/// Keeps the start of the step and goes half of the way; until the kick the records hold the velocity half-way.
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
  on.for_each(p.fluid_count,
              declare<Reads<field::place, field::flow, field::matter, field::position, field::rates, field::sediment>,
                      Writes<field::place, field::flow, field::matter, field::position>>([=] HOST_DEVICE(Index i) {
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
              }));
}

/// Velocities of the start with the accelerations half-way.
template <class Device>
void kick_from_start(Device& on, Particles<Device>& p, const StepState* state,
                     const typename Device::template Buffer<StepStart>& start) {
  const StepStart* kept = start.data();
  Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  on.for_each(p.fluid_count, declare<Reads<field::rates>, Writes<field::flow>>([=] HOST_DEVICE(Index i) {
                const auto dt = static_cast<float>(state->step.dt);
                for (int c = 0; c < 3; ++c) {
                  records[i].velocity[c] = kept[i].velocity[c] + dt * rates[i].acceleration[c];
                }
              }));
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
  on.for_each(p.fluid_count,
              declare<Reads<field::place, field::flow, field::matter, field::rates>,
                      Writes<field::place, field::flow, field::matter, field::position>>([=] HOST_DEVICE(Index i) {
                Record& r = records[i];
                if (r.volume == 0 || is_resting(r)) return;
                const StepStart& from = kept[i];
                positions[i] = from.position;
                float mean[3];
                for (int c = 0; c < 3; ++c) mean[c] = (from.velocity[c] + r.velocity[c]) / 2;
                whole_drift.move(i, mean);
                r.excess = from.excess + static_cast<float>(state->step.dt) * rates[i].excess_rate;
              }));
}

}  // namespace thalweg
