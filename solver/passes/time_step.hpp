#pragma once

#include <cmath>

#include "physics/water/viscosity_treatment.hpp"
#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

namespace thalweg {

template <class Device>
void find_extremes(Device& on, const Particles<Device>& p, StepState* state) {
  const Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  on.reduce_then(
      p.fluid(), Extremes{},
      declare<Reads<field::place, field::flow, field::matter, field::rates>, Writes<>>([=] HOST_DEVICE(Index i) {
        const Record& r = records[i];
        if (r.volume == 0) return Extremes{};
        Extremes e;
        for (int c = 0; c < 3; ++c) {
          e.speed2 += r.velocity[c] * r.velocity[c];
          e.acceleration2 += rates[i].acceleration[c] * rates[i].acceleration[c];
        }
        e.excess = fabsf(r.excess);
        e.finite = std::isfinite(e.speed2) && std::isfinite(e.acceleration2) && std::isfinite(e.excess);
        return e;
      }),
      [] HOST_DEVICE(Extremes a, const Extremes& b) {
        a.speed2 = a.speed2 > b.speed2 ? a.speed2 : b.speed2;
        a.acceleration2 = a.acceleration2 > b.acceleration2 ? a.acceleration2 : b.acceleration2;
        a.excess = a.excess > b.excess ? a.excess : b.excess;
        a.finite = a.finite && b.finite;
        return a;
      },
      [=] HOST_DEVICE(const Extremes& found) { state->step.extremes = found; });
}

/// Largest speed of the step, of fluid and moving walls [m/s].
HOST_DEVICE inline double largest_speed(const StepState& state) {
  return std::sqrt(double(std::fmax(state.step.extremes.speed2, state.walls.speed2)));
}

/// Shortens a step to dt [s], if it is longer.
HOST_DEVICE inline void shorten(TimeStep& step, double dt, Limiter limiter) {
  if (dt < step.dt) step.dt = dt, step.limiter = limiter;
}

/// The largest stable step of the water (Monaghan 1992; Morris et al. 1997) for what was found, C = scene.cfl:
///   sound      C h / (c + |u|max)
///   force      C sqrt(h / |a|max)            moving walls count in both
///   viscosity  0.125 h^2/nu of the water's own viscosity
/// Models shorten it further (limit_step).
template <int Dim>
HOST_DEVICE void choose_water_step(const Scene<Dim>& scene, StepState& state) {
  TimeStep& step = state.step;
  const double h = scene.smoothing_length;
  const double u = largest_speed(state);
  const double a = std::sqrt(double(std::fmax(step.extremes.acceleration2, state.walls.acceleration2)));
  step.dt = scene.cfl * h / (double(scene.sound_speed) * scene.fast_wave + u);
  step.limiter = Limiter::sound;
  if (a > 0) shorten(step, scene.cfl * std::sqrt(h / a), Limiter::force);
  if (scene.water_viscosity > 0) {
    shorten(step, 0.125 * h * h * double(scene.water_density) / double(scene.water_viscosity), Limiter::viscosity);
  }
}

/// Finds the largest eddy viscosity of the water [m^2/s] for limit_by_eddies; `eddy_viscosity` is the particle pass that
/// gives a particle's.
template <class Device, class EddyViscosity>
void find_largest_eddy_viscosity(Device& on, Index fluid_count, const EddyViscosity& eddy_viscosity, StepState* state) {
  on.reduce_then(
      fluid_count, 0.0F, eddy_viscosity, [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->eddy_viscosity = found; });
}

/// Shortens the step to 0.125 h^2/nu of the largest viscosity of the water, its own and that of the eddies.
template <int Dim>
HOST_DEVICE void limit_by_eddies(const Scene<Dim>& scene, StepState& state) {
  const double nu = double(scene.water_viscosity) / double(scene.water_density) + double(state.eddy_viscosity);
  if (nu > 0) shorten(state.step, viscous_time_step(scene.smoothing_length, nu), Limiter::viscosity);
}

/// Shortens the step so that an output time is met exactly; the two last steps share what is left, lest a tiny one
/// remain.
HOST_DEVICE inline void land_on_output(TimeStep& step, double longest) {
  if (2 * step.dt <= longest) return;
  step.limiter = Limiter::output;
  step.dt = step.dt >= longest ? longest : longest / 2;
}

/// A bound on every step of a scene [s].
template <int Dim>
double longest_stable_step(const Scene<Dim>& scene) {
  return scene.cfl * scene.smoothing_length / (double(scene.sound_speed) * scene.fast_wave);
}

}  // namespace thalweg
