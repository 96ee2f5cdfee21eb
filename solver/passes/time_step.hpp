#pragma once

#include <cmath>

#include "physics/pair_terms.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// What bounds a time step.
enum class Limiter { sound, force, viscosity, output };
inline constexpr const char* limiter_name(Limiter l) {
  switch (l) {
    case Limiter::sound:
      return "sound";
    case Limiter::force:
      return "force";
    case Limiter::viscosity:
      return "viscosity";
    case Limiter::output:
      break;
  }
  return "output";
}

/// Largest values in the scene; not finite or out of bounds when a run has diverged.
struct Extremes {
  float speed2 = 0;         // [m^2/s^2]
  float acceleration2 = 0;  // [m^2/s^4]
  float excess = 0;         // |rho/rho0 - 1| [-]
  bool finite = true;
};

struct TimeStep {
  double dt = 0;
  Limiter limiter = Limiter::sound;
  Extremes extremes;
};

/// How the viscous part of a step goes (models/implicit/viscosity.hpp).
struct ViscousState {
  // Sums over the particles near sediment of the residual r and the preconditioned one u = r/diagonal.
  double preconditioned = 0;  // r . u
  double before = 0;          // the same before the last iteration
  double alpha = 0;
  double beta = 0;
  double scale = 0;     // [kg m/s] what residuals are compared with
  double residual = 0;  // over that [-]
  int iterations = 0;
  int running = 0;    // more iterations are needed
  int converged = 1;  // always, where nothing is to be solved
};

/// The step under way, kept where the passes read it: on the device, so that the host need not wait between them. It
/// sends a fresh one before every step and looks at it after.
struct StepState {
  double longest = INFINITY;  // [s] the step may be
  TimeStep step;
  Extremes walls;                // those that move; squares of speed and acceleration
  float sediment_viscosity = 0;  // [m^2/s] largest, where it is treated explicitly
  int go = 1;                    // 0: the run has diverged
  int moves = 1;                 // 0: that, or the viscous solve is not at its end; no particle moves
  ViscousState viscous;
  std::int64_t capped = 0;  // particles whose viscosity was cut
  Index woken = 0;          // particles of the bed
  Index stopped = 0;
  float squared_drift = 0;  // [m^2] largest, since the lists were made; infinite where a particle left the domain
};

/// A density this far from its rest value means that the run has diverged: water does not compress by a third, and the
/// equation of state is used within a few percent.
inline constexpr float most_excess = 0.33F;

/// A step that finds the run diverged stops where it is and says so; no particle has moved by then.
HOST_DEVICE inline bool has_diverged(const Extremes& extremes) {
  return !extremes.finite || extremes.excess > most_excess;
}

template <class Device>
void find_extremes(Device& on, const Particles<Device>& p, StepState* state) {
  const Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  on.reduce_then(
      p.fluid_count, Extremes{},
      [=] HOST_DEVICE(Index i) {
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
      },
      [] HOST_DEVICE(Extremes a, const Extremes& b) {
        a.speed2 = a.speed2 > b.speed2 ? a.speed2 : b.speed2;
        a.acceleration2 = a.acceleration2 > b.acceleration2 ? a.acceleration2 : b.acceleration2;
        a.excess = a.excess > b.excess ? a.excess : b.excess;
        a.finite = a.finite && b.finite;
        return a;
      },
      [=] HOST_DEVICE(const Extremes& found) { state->step.extremes = found; });
}

/// Squares of the largest speed and acceleration of walls that move.
template <class Device>
void find_wall_extremes(Device& on, const Particles<Device>& p, StepState* state) {
  const Record* records = p.record.data() + p.fluid_count;
  const Rates* rates = p.rates.data() + p.fluid_count;
  on.reduce_then(
      p.count - p.fluid_count, Extremes{},
      [=] HOST_DEVICE(Index i) {
        Extremes e;
        if (records[i].volume == 0) return e;
        for (int c = 0; c < 3; ++c) {
          e.speed2 += records[i].velocity[c] * records[i].velocity[c];
          e.acceleration2 += rates[i].acceleration[c] * rates[i].acceleration[c];
        }
        return e;
      },
      [] HOST_DEVICE(Extremes a, const Extremes& b) {
        a.speed2 = a.speed2 > b.speed2 ? a.speed2 : b.speed2;
        a.acceleration2 = a.acceleration2 > b.acceleration2 ? a.acceleration2 : b.acceleration2;
        return a;
      },
      [=] HOST_DEVICE(const Extremes& found) { state->walls = found; });
}

/// Largest kinematic viscosity of the sediment [m^2/s].
template <int Dim, class Device>
void find_sediment_viscosity(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  const Record* records = p.record.data();
  const float density_at_rest = scene.sediment_density;
  on.reduce_then(
      p.fluid_count, 0.0F,
      [=] HOST_DEVICE(Index i) {
        const Record& r = records[i];
        return r.phase == phase_sediment && r.volume != 0 ? r.viscosity / (density_at_rest * (1 + r.excess)) : 0.0F;
      },
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->sediment_viscosity = found; });
}

template <int Dim>
HOST_DEVICE bool has_explicit_sediment(const Scene<Dim>& scene) {
  return scene.has_sediment && scene.viscosity == ViscosityTreatment::explicit_steps;
}

/// The largest stable step (Monaghan 1992; Morris et al. 1997) for what was found, C = scene.cfl:
///   sound      C h / (c + |u|max)
///   force      C sqrt(h / |a|max)            walls that move count in both
///   viscosity  0.125 h^2/nu of what is treated explicitly: the water's own viscosity, the sediment's and that between
///              both where they are not implicit or capped
template <int Dim>
HOST_DEVICE void choose_step(const Scene<Dim>& scene, StepState& state) {
  TimeStep& step = state.step;
  const auto shorten = [&step](double dt, Limiter limiter) {
    if (dt < step.dt) step.dt = dt, step.limiter = limiter;
  };
  const double h = scene.smoothing_length;
  const double u = std::sqrt(double(std::fmax(step.extremes.speed2, state.walls.speed2)));
  const double a = std::sqrt(double(std::fmax(step.extremes.acceleration2, state.walls.acceleration2)));
  step.dt = scene.cfl * h / (double(scene.sound_speed) * scene.seepage.fast_wave + u);
  step.limiter = Limiter::sound;
  if (a > 0) shorten(scene.cfl * std::sqrt(h / a), Limiter::force);
  if (scene.water_viscosity > 0) {
    shorten(0.125 * h * h * double(scene.water_density) / double(scene.water_viscosity), Limiter::viscosity);
  }
  if (has_explicit_sediment(scene)) {
    const float lighter = scene.water_density < scene.sediment_density ? scene.water_density : scene.sediment_density;
    const float between = interface_viscosity(scene.water_viscosity, scene.water_density, static_cast<float>(2 * u),
                                              static_cast<float>(scene.spacing)) /
                          lighter;
    const double nu = state.sediment_viscosity > between ? state.sediment_viscosity : between;
    shorten(viscous_time_step(h, nu), Limiter::viscosity);
  }
}

/// Shortens the step so that an output time is met exactly; the two last steps share what is left, lest a tiny one
/// remain.
HOST_DEVICE inline void land_on_output(TimeStep& step, double longest) {
  if (2 * step.dt <= longest) return;
  step.limiter = Limiter::output;
  step.dt = step.dt >= longest ? longest : longest / 2;
}

/// Chooses the step; where the run has diverged nothing more goes on.
template <int Dim, class Device>
void stable_time_step(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  find_extremes(on, p, state);
  if (scene.has_moving_walls) find_wall_extremes(on, p, state);
  if (has_explicit_sediment(scene)) find_sediment_viscosity(on, p, scene, state);
  on.for_each(1, [=] HOST_DEVICE(Index) {
    choose_step(scene, *state);
    state->go = state->moves = has_diverged(state->step.extremes) ? 0 : 1;
    land_on_output(state->step, state->longest);
  });
}

/// A bound on every step of a scene [s].
template <int Dim>
double longest_stable_step(const Scene<Dim>& scene) {
  return scene.cfl * scene.smoothing_length / (double(scene.sound_speed) * scene.seepage.fast_wave);
}

}  // namespace thalweg
