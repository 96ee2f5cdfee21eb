#pragma once

#include "physics/no_slip.hpp"
#include "physics/water/viscosity_treatment.hpp"
#include "solver/models/bed/coupling.hpp"
#include "solver/passes/sweep.hpp"
#include "solver/passes/time_step.hpp"
#include "solver/state/step_state.hpp"

// Viscosity of the sediment without a solve: explicit steps, or explicit with the viscosity cut.
namespace thalweg {

/// Pair sweep: change of velocity by viscosity in a step [m/s], from the velocities at hand; in place of the explicit
/// acceleration, which the velocities have had already and the next step finds anew.
template <int Dim, class Coupling>
struct ExplicitViscositySweep {
  using neighbours = typename Coupling::neighbours;
  using reads = Reads<field::mass, field::loaded_mass>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = Coupling::kernel;
  template <class L>
  struct Sum {
    Vec<Dim, L> exchange;
    WallDrag<Dim, L> walls;
  };

  Rates* rates;
  const float* mass;
  Coupling coupling;
  const StepState* state;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L k = coupling.coefficient(a, b, u, g);
    for (int c = 0; c < Dim; ++c) sum.exchange[c] += k * u[c];
    sum.walls.add(lane_select(is_wall(b), k, L(0.0F)), g, u);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    for (float& a : rates[i].acceleration) a = 0;
    const auto dt = static_cast<float>(state->step.dt);
    const float more_of_walls = coupling.scene.no_slip.excess(sum.walls);
    for (int c = 0; c < Dim; ++c) {
      rates[i].acceleration[axis<Dim>(c)] = -dt * (sum.exchange[c] + more_of_walls * sum.walls.exchange[c]) / mass[i];
    }
  }
};

/// Changes the velocities of the fluid near sediment by the viscous forces of the velocities at hand.
template <int Dim, class Device, class Coupling>
void apply_explicit_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                              const Coupling& coupling) {
  Record* records = p.record.data();
  Rates* rates = p.rates.data();
  sweep(on, p, scene, p.near_sediment(), ExplicitViscositySweep<Dim, Coupling>{rates, p.inertia(), coupling, state});
  for_each_member(on, p.list(), p.near_sediment(),
                  declare<Reads<field::flow, field::rates>, Writes<field::flow>>([=] HOST_DEVICE(Index i) {
                    for (int c = 0; c < 3; ++c) records[i].velocity[c] += rates[i].acceleration[c];
                  }));
}

/// Cuts the sediment's viscosity to what the step can take, and counts the particles it was cut for.
template <int Dim, class Device>
void cap_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  Record* records = p.record.data();
  const auto h = static_cast<float>(scene.smoothing_length);
  const float density_at_rest = scene.sediment_density;
  on.reduce_then(
      p.fluid_count, std::int64_t{0},
      declare<Reads<field::place, field::matter>, Writes<field::matter>>([=] HOST_DEVICE(Index i) -> std::int64_t {
        Record& r = records[i];
        if (!is_sediment(r) || r.volume == 0) return 0;
        const float cap = viscosity_cap(density_at_rest * (1 + r.excess), h, static_cast<float>(state->step.dt));
        if (!(r.viscosity > cap)) return 0;
        r.viscosity = cap;
        return 1;
      }),
      [] HOST_DEVICE(std::int64_t a, std::int64_t b) { return a + b; },
      [=] HOST_DEVICE(std::int64_t found) { state->capped = found; });
}

/// Largest kinematic viscosity of the sediment [m^2/s].
template <int Dim, class Device>
void find_sediment_viscosity(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  const Record* records = p.record.data();
  const float density_at_rest = scene.sediment_density;
  on.reduce_then(
      p.fluid_count, 0.0F, declare<Reads<field::place, field::matter>, Writes<>>([=] HOST_DEVICE(Index i) {
        const Record& r = records[i];
        return is_sediment(r) && r.volume != 0 ? r.viscosity / (density_at_rest * (1 + r.excess)) : 0.0F;
      }),
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->sediment_viscosity = found; });
}

/// Shortens the step to 0.125 h^2/nu of the sediment's viscosity and of that between water and sediment.
template <int Dim>
HOST_DEVICE void limit_by_sediment_viscosity(const Scene<Dim>& scene, StepState& state) {
  const float lighter = scene.water_density < scene.sediment_density ? scene.water_density : scene.sediment_density;
  const float between =
      interface_viscosity(scene.water_viscosity, scene.water_density, static_cast<float>(2 * largest_speed(state)),
                          static_cast<float>(scene.spacing)) /
      lighter;
  const double nu = state.sediment_viscosity > between ? state.sediment_viscosity : between;
  shorten(state.step, viscous_time_step(scene.smoothing_length, nu), Limiter::viscosity);
}

}  // namespace thalweg
