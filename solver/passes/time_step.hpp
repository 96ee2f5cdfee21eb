#pragma once

#include <cmath>

#include "solver/particles.hpp"
#include "solver/physics/pair_terms.hpp"

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

/// A density this far from its rest value means that the run has diverged: water does not compress by a third, and the
/// equation of state is used within a few percent.
inline constexpr float most_excess = 0.33F;

template <class Device>
Extremes find_extremes(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Rates* rates = p.rates.data();
  return on.reduce(
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
      });
}

/// Largest kinematic viscosity of the sediment and between it and the water [m^2/s], for speed differences up to u
/// [m/s].
template <int Dim, class Device>
double largest_sediment_viscosity(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, double u) {
  const Record* records = p.record.data();
  const float density_at_rest = scene.sediment_density;
  const float in_the_bed = on.reduce(
      p.fluid_count, 0.0F,
      [=] HOST_DEVICE(Index i) {
        const Record& r = records[i];
        return r.phase == phase_sediment && r.volume != 0 ? r.viscosity / (density_at_rest * (1 + r.excess)) : 0.0F;
      },
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; });
  const float lighter = scene.water_density < density_at_rest ? scene.water_density : density_at_rest;
  const float between = interface_viscosity(scene.water_viscosity, scene.water_density, static_cast<float>(u),
                                            static_cast<float>(scene.spacing)) /
                        lighter;
  return in_the_bed > between ? in_the_bed : between;
}

/// The largest stable step (Monaghan 1992; Morris et al. 1997), C = scene.cfl:
///   sound      C h / (c + |u|max)
///   force      C sqrt(h / |a|max)
///   viscosity  0.125 h^2/nu of what is treated explicitly: the water's own viscosity, the sediment's where it is not
///              implicit or capped
template <int Dim, class Device>
TimeStep stable_time_step(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  TimeStep step;
  step.extremes = find_extremes(on, p);
  const double h = scene.smoothing_length;
  const double u = std::sqrt(double(step.extremes.speed2));
  const double a = std::sqrt(double(step.extremes.acceleration2));
  step.dt = scene.cfl * h / (double(scene.sound_speed) * scene.seepage.fast_wave + u);
  const double force = a > 0 ? scene.cfl * std::sqrt(h / a) : step.dt;
  if (force < step.dt) step.dt = force, step.limiter = Limiter::force;
  if (scene.water_viscosity > 0) {
    const double viscous = 0.125 * h * h * double(scene.water_density) / double(scene.water_viscosity);
    if (viscous < step.dt) step.dt = viscous, step.limiter = Limiter::viscosity;
  }
  if (scene.has_sediment && scene.viscosity == ViscosityTreatment::explicit_steps) {
    const double viscous = viscous_time_step(h, largest_sediment_viscosity(on, p, scene, 2 * u));
    if (viscous < step.dt) step.dt = viscous, step.limiter = Limiter::viscosity;
  }
  return step;
}

}  // namespace thalweg
