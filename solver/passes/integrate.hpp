#pragma once

#include <type_traits>

#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

// Leapfrog: velocities by the accelerations at the old places, half of the way by the new velocities, densities by the
// rates half-way, the other half of the way. One force sweep a step; stable up to the acoustic Courant number of about
// 0.5 measured in tests/solver. Rates taken at the end of the way instead are of first order, and wrong in the same
// sense on the way in and out: a drop that bounced off a floor kept 15 % of the impact's compression, and gained 4 to
// 10 % of its energy from every bounce.
namespace thalweg {

namespace field {
/// The work quad during the motion, where some particles drift over their velocity (Scene::has_drift): the drift's.
inline constexpr Field drift_velocity{"DriftVelocity", quad_work};
}  // namespace field

/// True if the equations of motion move particle i; `roles` is nullptr where they move all.
HOST_DEVICE inline bool is_integrated(const Role* roles, Index i) {
  return roles == nullptr || roles[i] == Role::integrated;
}

/// Particle pass: velocities by the explicit accelerations.
struct KickPass {
  using reads = Reads<field::flow, field::rates, field::role>;
  using writes = Writes<field::flow>;

  Record* records;
  const Rates* rates;
  const Role* roles;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const {
    if (!is_integrated(roles, i)) return;
    const auto dt = static_cast<float>(state->step.dt);
    for (int c = 0; c < 3; ++c) records[i].velocity[c] += dt * rates[i].acceleration[c];
  }
};

/// Particle pass: places by the velocities, a `share` of the step; a particle that leaves the domain loses its volume
/// and is out of every sum until the next sort drops it.
template <int Dim>
struct DriftPass {
  using reads = Reads<field::place, field::flow, field::position>;
  using writes = Writes<field::place, field::flow, field::matter, field::position>;

  Record* records;
  Position* positions;
  Scene<Dim> scene;
  const StepState* state;
  double share;

  HOST_DEVICE void operator()(Index i) const { move(i, records[i].velocity); }

  /// Moves particle i with a velocity [m/s] of three components.
  HOST_DEVICE void move(Index i, const float* velocity) const {
    Record& r = records[i];
    if (r.volume == 0) return;
    const double dt = share * state->step.dt;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      double& x = positions[i].x[c];
      x += dt * double(velocity[c]);
      if (scene.lattice.periodic[k]) {
        if (x < scene.lattice.origin[k]) x += scene.lattice.range[k];
        if (x >= scene.lattice.origin[k] + scene.lattice.range[k]) x -= scene.lattice.range[k];
      } else if (!(x >= scene.domain_from[k] && x <= scene.domain_to[k])) {
        r.volume = 0;
        r.kind = kind::wall;
        r.pressure = 0;
        return;
      }
      r.place[c] = scene.lattice.place(k, x);
    }
  }
};

/// Particle pass: DriftPass with velocity plus drift.
template <int Dim>
struct CarriedDriftPass {
  using reads = Reads<field::place, field::flow, field::position, field::drift_velocity>;
  using writes = typename DriftPass<Dim>::writes;

  DriftPass<Dim> drift;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = drift.records[i];
    float velocity[3];
    for (int c = 0; c < 3; ++c) velocity[c] = r.velocity[c] + r.work[c];
    drift.move(i, velocity);
  }
};

/// Particle pass: densities by the rates half-way, then the second half of the way.
template <class Drift>
struct DensityAndDriftPass {
  using reads = typename Drift::reads::template With<field::matter, field::rates, field::role>;
  using writes = typename Drift::writes;

  Drift drift;
  Record* records;
  const Rates* rates;
  const Role* roles;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const {
    if (is_integrated(roles, i)) records[i].excess += static_cast<float>(state->step.dt) * rates[i].excess_rate;
    drift(i);
  }
};

template <class Device>
void kick(Device& on, Particles<Device>& p, const StepState* state) {
  on.for_each(p.fluid_count, KickPass{p.record.data(), p.rates.data(), p.roles(), state});
}

template <int Dim, class Device>
void drift(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state, double share) {
  const DriftPass<Dim> pass{p.record.data(), p.position.data(), scene, state, share};
  if (scene.has_drift) return on.for_each(p.fluid_count, CarriedDriftPass<Dim>{pass});
  on.for_each(p.fluid_count, pass);
}

template <int Dim, class Device>
void update_density_and_drift(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                              double share) {
  const DriftPass<Dim> pass{p.record.data(), p.position.data(), scene, state, share};
  const auto run = [&](const auto& drift_pass) {
    on.for_each(p.fluid_count, DensityAndDriftPass<std::remove_cvref_t<decltype(drift_pass)>>{
                                   drift_pass, p.record.data(), p.rates.data(), p.roles(), state});
  };
  if (scene.has_drift) return run(CarriedDriftPass<Dim>{pass});
  run(pass);
}

}  // namespace thalweg
