#pragma once

#include <cmath>

#include "solver/models/implicit/viscosity.hpp"
#include "solver/models/seepage/mixture.hpp"
#include "solver/passes/integrate.hpp"

// The viscous part of a step, by the treatment the scene has chosen.
namespace thalweg {

/// How the viscous part of a step went.
struct ViscousResult {
  int iterations = 0;
  double residual = 0;  // over the momentum one step of gravity gives [-]
  bool converged = true;
  int retries = 0;          // solves that had to be made again
  std::int64_t capped = 0;  // particles whose viscosity was cut
};

/// Pair sweep: change of velocity by viscosity in a step [m/s], from the velocities at hand; into the work quad.
template <int Dim>
struct ExplicitViscositySweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    Vec<Dim, L> exchange;
    WallDrag<Dim, L> walls;
  };

  Record* records;
  const float* mass;
  ViscousCoupling<Dim> coupling;
  const StepState* state;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
    const L k = coupling.coefficient(a, b, u, closeness);
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
    sum.walls.add(lane_select(b.phase < L(phase_wall + 0.5F), k, L(0.0F)), s, u);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    for (float& w : records[i].work) w = 0;
    const auto dt = static_cast<float>(state->step.dt);
    const float more_of_walls = coupling.scene.no_slip.excess(sum.walls);
    for (int c = 0; c < Dim; ++c) {
      records[i].work[axis<Dim>(c)] = -dt * (sum.exchange[c] + more_of_walls * sum.walls.exchange[c]) / mass[i];
    }
  }
};

/// Changes the velocities of the fluid near sediment by the viscous forces of the velocities at hand.
template <int Dim, class Device>
void apply_explicit_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state) {
  Record* records = p.record.data();
  on.template sweep<Dim>(p.list(), p.near_sediment(), records, scene.lattice.quantum,
                         ExplicitViscositySweep<Dim>{records, p.mass.data(), {scene}, state});
  for_each_member(on, p.list(), p.near_sediment(), [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].velocity[c] += records[i].work[c];
  });
}

/// Cuts the sediment's viscosity to what the step can take, and counts the particles it was cut for.
template <int Dim, class Device>
void cap_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  Record* records = p.record.data();
  const auto h = static_cast<float>(scene.smoothing_length);
  const float density_at_rest = scene.sediment_density;
  on.reduce_then(
      p.fluid_count, std::int64_t{0},
      [=] HOST_DEVICE(Index i) -> std::int64_t {
        Record& r = records[i];
        if (r.phase != phase_sediment || r.volume == 0) return 0;
        const float cap = viscosity_cap(density_at_rest * (1 + r.excess), h, static_cast<float>(state->step.dt));
        if (!(r.viscosity > cap)) return 0;
        r.viscosity = cap;
        return 1;
      },
      [] HOST_DEVICE(std::int64_t a, std::int64_t b) { return a + b; },
      [=] HOST_DEVICE(std::int64_t found) { state->capped = found; });
}

/// Begins what viscosity does to the velocities; with an implicit treatment iterate_viscosity and end_viscosity follow.
template <int Dim, class Device>
void begin_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const Mixture<Device>& mix,
                     ViscousSystem<Device>& system, StepState* state) {
  if (scene.viscosity != ViscosityTreatment::implicit) {
    if (scene.viscosity == ViscosityTreatment::capped) cap_viscosity(on, p, scene, state);
    apply_explicit_viscosity(on, p, scene, state);
  } else if (scene.seepage.mixture) {
    prepare_mixture_viscosity(on, p, scene, mix);
    begin_viscous_solve(on, p, scene, system, state, MixtureCoupling<Dim>{scene});
  } else {
    begin_viscous_solve(on, p, scene, system, state, ViscousCoupling<Dim>{scene});
  }
}

/// Goes on for at most so many iterations.
template <int Dim, class Device>
void iterate_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                       StepState* state, int iterations) {
  if (scene.viscosity != ViscosityTreatment::implicit) return;
  if (scene.seepage.mixture) {
    iterate_viscous_solve(on, p, scene, system, state, iterations, MixtureCoupling<Dim>{scene});
  } else {
    iterate_viscous_solve(on, p, scene, system, state, iterations, ViscousCoupling<Dim>{scene});
  }
}

/// Velocities after the viscous part; where it is not at its end, or has failed, no particle moves (StepState::moves).
template <int Dim, class Device>
void end_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                   StepState* state) {
  if (scene.viscosity == ViscosityTreatment::implicit) end_viscous_solve(on, p, system, state);
}

namespace viscosity {

/// How often a step may be halved when its solve fails.
inline constexpr int most_halvings = 4;

/// Whether another try can help: a solve that ran out of iterations, not one whose numbers are broken.
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
    on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
      const auto half = static_cast<float>(state->step.dt / 2);
      for (int c = 0; c < 3; ++c) records[i].velocity[c] -= half * rates[i].acceleration[c];
    });
  }
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    for (float& a : sediment[i].viscous_acceleration) a = 0;
  });
  if (!halve) return;
  on.for_each(1, [=] HOST_DEVICE(Index) {
    state->step.dt /= 2;
    state->step.limiter = Limiter::viscosity;
  });
}

}  // namespace viscosity

}  // namespace thalweg
