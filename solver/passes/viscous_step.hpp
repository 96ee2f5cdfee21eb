#pragma once

#include "solver/passes/integrate.hpp"
#include "solver/passes/time_step.hpp"
#include "solver/passes/viscosity.hpp"

// The viscous part of a step, by the treatment the scene has chosen.
namespace thalweg {

/// Pair sweep: change of velocity by viscosity in a step [m/s], from the velocities at hand; into the work quad.
template <int Dim>
struct ExplicitViscositySweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    Vec<Dim, L> exchange;
  };

  Record* records;
  const float* mass;
  ViscousCoupling<Dim> coupling;
  float dt;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L closeness = coupling.scene.kernel.closeness(lane_sqrt(s.r2));
    const L k = L(dt) * coupling.coefficient(a, b, u, closeness);
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    for (float& w : records[i].work) w = 0;
    for (int c = 0; c < Dim; ++c) records[i].work[axis<Dim>(c)] = -sum.exchange[c] / mass[i];
  }
};

/// Changes the velocities of the fluid near sediment by the viscous forces of the velocities at hand.
template <int Dim, class Device>
void apply_explicit_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, float dt) {
  Record* records = p.record.data();
  on.template sweep<Dim>(p.list(), p.near_sediment(), records, scene.lattice.quantum,
                         ExplicitViscositySweep<Dim>{records, p.mass.data(), {scene}, dt});
  for_each_member(on, p.list(), p.near_sediment(), [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) records[i].velocity[c] += records[i].work[c];
  });
}

/// Cuts the sediment's viscosity to what the step can take; returns how many particles it was cut for.
template <int Dim, class Device>
std::int64_t cap_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, double dt) {
  Record* records = p.record.data();
  const auto h = static_cast<float>(scene.smoothing_length);
  const auto step = static_cast<float>(dt);
  const float density_at_rest = scene.sediment_density;
  return on.reduce(
      p.fluid_count, std::int64_t{0},
      [=] HOST_DEVICE(Index i) -> std::int64_t {
        Record& r = records[i];
        if (r.phase != phase_sediment || r.volume == 0) return 0;
        const float cap = viscosity_cap(density_at_rest * (1 + r.excess), h, step);
        if (!(r.viscosity > cap)) return 0;
        r.viscosity = cap;
        return 1;
      },
      [] HOST_DEVICE(std::int64_t a, std::int64_t b) { return a + b; });
}

namespace viscosity {

/// How often a step may be halved when its solve fails.
inline constexpr int most_halvings = 4;

/// Solves; where conjugate gradients fail, again from no guess, then with shorter and shorter steps, whose systems are
/// better conditioned. Tells how often it tried again; leaves the velocities of the explicit part if all fail.
template <int Dim, class Device>
ViscousResult solve_or_shorten(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                               TimeStep& step) {
  ViscousResult result = solve_viscosity(on, p, scene, system, static_cast<float>(step.dt));
  while (!result.converged && std::isfinite(result.residual) && result.retries <= most_halvings) {
    if (result.retries > 0) {
      kick(on, p, -step.dt / 2);
      step.dt /= 2;
      step.limiter = Limiter::viscosity;
    }
    Sediment* sediment = p.sediment.data();
    on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
      for (float& a : sediment[i].viscous_acceleration) a = 0;
    });
    ViscousResult again = solve_viscosity(on, p, scene, system, static_cast<float>(step.dt));
    again.iterations += result.iterations;
    again.retries = result.retries + 1;
    result = again;
  }
  return result;
}

}  // namespace viscosity

/// Velocities after the viscous part of a step; may shorten the step.
template <int Dim, class Device>
ViscousResult apply_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, ViscousSystem<Device>& system,
                              TimeStep& step) {
  if (scene.viscosity == ViscosityTreatment::implicit) {
    return viscosity::solve_or_shorten(on, p, scene, system, step);
  }
  ViscousResult result;
  if (scene.viscosity == ViscosityTreatment::capped) result.capped = cap_viscosity(on, p, scene, step.dt);
  apply_explicit_viscosity(on, p, scene, static_cast<float>(step.dt));
  return result;
}

}  // namespace thalweg
