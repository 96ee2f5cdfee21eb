#pragma once

#include <cmath>

#include "solver/backend/device.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/state/step_state.hpp"

namespace thalweg {

namespace viscosity {

/// A step may be halved so often when its solve fails.
inline constexpr int most_halvings = 4;

/// True if another try can help: a solve that ran out of iterations, not one whose numbers are broken.
inline bool may_retry(const ViscousState& v, int retries) {
  return v.running == 0 && v.converged == 0 && std::isfinite(v.residual) && retries <= most_halvings;
}

/// Readies a step whose solve has failed for another try: from no guess, and after the first of them with half the
/// step, whose system is better conditioned.
template <class Device>
void prepare_retry(Device& on, Particles<Device>& p, StepState* state, bool halve) {
  Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  Sediment* sediment = p.sediment.data();
  if (halve) {
    on.for_each(p.fluid_count, declare<Reads<field::flow, field::rates>, Writes<field::flow>>([=] HOST_DEVICE(Index i) {
                  const auto half = static_cast<float>(state->step.dt / 2);
                  for (int c = 0; c < 3; ++c) records[i].velocity[c] -= half * rates[i].acceleration[c];
                }));
  }
  on.for_each(p.fluid_count, declare<Reads<>, Writes<field::sediment>>([=] HOST_DEVICE(Index i) {
                for (float& a : sediment[i].viscous_acceleration) a = 0;
              }));
  if (!halve) return;
  on.for_each(1, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index) {
                state->step.dt /= 2;
                state->step.limiter = Limiter::viscosity;
              }));
}

}  // namespace viscosity

}  // namespace thalweg
