#pragma once

#include <algorithm>
#include <vector>

#include "solver/passes/bed_states.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/integrate.hpp"
#include "solver/passes/mixture.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/moving_walls.hpp"
#include "solver/passes/neighbours.hpp"
#include "solver/passes/pore_pressure.hpp"
#include "solver/passes/pressure.hpp"
#include "solver/passes/rest.hpp"
#include "solver/passes/sediment_strength.hpp"
#include "solver/passes/time_step.hpp"
#include "solver/passes/viscous_step.hpp"
#include "solver/timing.hpp"

namespace thalweg {

/// What the step keeps between calls beside the particles.
template <class Device>
struct Workspace {
  ViscousSystem<Device> viscous;
  ColumnWeight<Device> weight;
  Mixture<Device> mixture;
  PoreDiffusion<Device> pore_diffusion;
  std::int64_t list_rebuilds = 0;
  std::vector<WallMotion> motions;
  double time = 0;            // [s] at the start of the step
  bool walls_moving = false;  // at the start of the last step
};

struct StepResult {
  TimeStep step;
  ViscousResult viscous;
  int pressure_sweeps = 0;  // of the effective pressure from Laplace's equation
  std::vector<ExcludedParticle> excluded;
};

/// A step that finds the run diverged stops where it is and says so; no particle has moved by then.
inline bool has_diverged(const StepResult& result) {
  return !result.step.extremes.finite || result.step.extremes.excess > most_excess || !result.viscous.converged;
}

/// Shortens the step so that an output time is met exactly; the two last steps share what is left, lest a tiny one
/// remain.
inline void land_on_output(TimeStep& step, double longest) {
  if (2 * step.dt <= longest) return;
  step.limiter = Limiter::output;
  step.dt = step.dt >= longest ? longest : longest / 2;
}

/// THE algorithm: one step in time, at most `longest` seconds.
template <int Dim, class Device>
StepResult advance(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work, double longest,
                   Timing& timing) {
  using H = Heading;
  StepResult result;
  const std::int64_t lists_before = work.list_rebuilds;
  const bool moving_walls = scene.has_moving_walls;
  bool walls_turned = false;  // started or stopped
  if (moving_walls) {
    timing.time(H::move_walls, [&] {
      const bool moving = hold_walls(on, p, scene, work.motions, work.time);
      walls_turned = moving != work.walls_moving;
      work.walls_moving = moving;
    });
  }
  timing.time(H::refresh_neighbours, [&] { result.excluded = refresh_neighbours(on, p, scene, work.list_rebuilds); });
  const bool new_lists = work.list_rebuilds != lists_before;
  const bool mixture = scene.seepage.mixture;
  timing.time(H::apply_equation_of_state, [&] {
    mixture ? apply_mixture_state(on, p, scene, work.mixture) : apply_equation_of_state(on, p, scene);
  });
  // Pore pressure takes from the weight in every step.
  if ((new_lists || scene.seepage.pore_pressure) && scene.has_sediment) {
    timing.time(H::weigh_sediment, [&] { weigh_sediment(on, p, scene, work.weight); });
  }
  if ((new_lists || walls_turned) && scene.may_rest) timing.time(H::update_rest, [&] { list_active_clusters(on, p); });
  timing.time(H::extrapolate_to_walls, [&] {
    if (p.any_resting) extrapolate_to_resting(on, p, scene);
    mixture ? extrapolate_mixture_to_walls(on, p, scene) : extrapolate_to_walls(on, p, scene);
  });
  if (scene.has_sediment) {
    timing.time(H::apply_rheology, [&] {
      result.pressure_sweeps = solve_effective_pressure(on, p, scene);
      apply_rheology(on, p, scene);
    });
  }
  timing.time(H::compute_accelerations, [&] {
    mixture ? compute_mixture_accelerations(on, p, scene, work.mixture) : compute_accelerations(on, p, scene);
  });
  timing.time(H::stable_time_step, [&] { result.step = stable_time_step(on, p, scene); });
  if (has_diverged(result)) return result;
  land_on_output(result.step, longest);

  const auto move_walls_by = [&](double share) {
    if (!moving_walls) return;
    timing.time(H::move_walls, [&] { move_walls(on, p, scene, work.motions, work.time, result.step.dt, share); });
  };
  timing.time(H::kick, [&] { kick(on, p, result.step.dt); });
  if (scene.has_sediment) move_walls_by(0);  // viscosity drags at the velocity the walls go with
  if (scene.has_sediment) {
    timing.time(H::solve_viscosity, [&] {
      result.viscous = mixture ? solve_mixture_viscosity(on, p, scene, work.mixture, work.viscous,
                                                         static_cast<float>(result.step.dt))
                               : apply_viscosity(on, p, scene, work.viscous, result.step);
    });
  }
  if (has_diverged(result)) return result;
  const double dt = result.step.dt;  // viscosity may have shortened it
  timing.time(H::drift, [&] { drift(on, p, scene, dt / 2); });
  move_walls_by(0.5);
  timing.time(H::compute_density_rates, [&] {
    mixture ? compute_mixture_density_rates(on, p, scene, work.mixture) : compute_density_rates(on, p, scene);
  });
  timing.time(H::update_density, [&] { update_density(on, p, dt); });
  timing.time(H::drift, [&] { drift(on, p, scene, dt / 2); });
  move_walls_by(1);
  if (scene.seepage.pore_pressure) {
    timing.time(H::advance_pore_pressure, [&] { advance_pore_pressure(on, p, scene, work.pore_diffusion, dt); });
  }
  bool woken = false;
  if (scene.has_states) {
    timing.time(H::update_bed_states, [&] {
      if (new_lists) clear_bed_surface(on, p);
      woken = update_bed_states(on, p, scene, dt);
    });
  }
  if (scene.may_rest) {
    timing.time(H::update_rest, [&] {
      if (work.walls_moving && wake_beside_moving_walls(on, p, scene)) woken = true;
      update_rest(on, p, scene, dt, woken);
    });
  }
  return result;
}

}  // namespace thalweg
