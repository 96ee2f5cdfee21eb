#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "solver/lists/neighbours.hpp"
#include "solver/models/bed/sediment_strength.hpp"
#include "solver/models/implicit/viscous_step.hpp"
#include "solver/models/moving_walls/moving_walls.hpp"
#include "solver/models/pore_pressure/pore_pressure.hpp"
#include "solver/models/rest/rest.hpp"
#include "solver/models/seepage/mixture.hpp"
#include "solver/models/states/bed_states.hpp"
#include "solver/models/two_pass/two_pass.hpp"
#include "solver/passes/continuity.hpp"
#include "solver/passes/integrate.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/pressure.hpp"
#include "solver/passes/time_step.hpp"
#include "solver/timing.hpp"

namespace thalweg {

/// What the step keeps between calls beside the particles.
template <class Device>
struct Workspace {
  ViscousSystem<Device> viscous;
  ColumnWeight<Device> weight;
  Mixture<Device> mixture;
  PoreDiffusion<Device> pore_diffusion;
  typename Device::template Buffer<StepState> state;  // one, of the step under way
  typename Device::template Buffer<StepStart> start;  // of the particles; empty unless scene.two_pass
  std::int64_t list_rebuilds = 0;
  std::vector<WallMotion> motions;
  double time = 0;            // [s] at the start of the step
  bool walls_moving = false;  // at the start of the last step

  std::optional<float> squared_drift;  // [m^2] StepState's after the last step, where it is known
  bool new_lists = false;              // made since the last step
  int viscous_iterations = 0;          // of the last step
  std::uint64_t lists = 1;             // counts changes of any list of clusters
  std::uint64_t lists_before = 0;      // the same at the start of the last step
};

struct StepResult {
  TimeStep step;
  ViscousResult viscous;
  int pressure_sweeps = 0;  // of the effective pressure from Laplace's equation
  std::vector<ExcludedParticle> excluded;
};

inline bool has_diverged(const StepResult& result) {
  return has_diverged(result.step.extremes) || !result.viscous.converged;
}

/// Takes out particles that have left the domain and makes new lists, if some particle has used up its skin.
template <int Dim, class Device>
std::vector<ExcludedParticle> refresh_neighbours(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                                 Workspace<Device>& work) {
  work.state.resize(1);
  if (!work.squared_drift && !p.listed_at.empty()) {
    neighbours::find_squared_drift(on, p, scene, work.state.data());
    work.squared_drift = on.look(work.state.data()).squared_drift;
  }
  if (!p.listed_at.empty() && !are_worn_out(scene, *work.squared_drift)) return {};
  auto excluded = rebuild_lists(on, p, scene);
  work.new_lists = true;
  work.squared_drift = 0;
  ++work.list_rebuilds;
  ++work.lists;
  return excluded;
}

/// The two-pass integrator's accelerations and density rates: of half-way (models/two_pass/two_pass.hpp).
template <int Dim, class Device>
void evaluate_half_way(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work,
                       Timing& timing) {
  using H = Heading;
  timing.time(H::compute_density_rates, [&] { compute_density_rates(on, p, scene); });
  timing.time(H::drift, [&] { go_half_way(on, p, scene, work.state.data(), work.start); });
  timing.time(H::apply_equation_of_state, [&] { apply_equation_of_state(on, p, scene); });
  timing.time(H::extrapolate_to_walls, [&] {
    if (p.any_resting) extrapolate_to_resting(on, p, scene);
    extrapolate_to_walls(on, p, scene);
  });
  timing.time(H::compute_accelerations, [&] { compute_accelerations(on, p, scene); });
  timing.time(H::compute_density_rates, [&] { compute_density_rates(on, p, scene); });
  timing.time(H::drift, [&] { take_back_velocities(on, p, work.start); });
}

/// The step up to the viscous part of its velocities. Returns the sweeps that the effective pressure took.
template <int Dim, class Device>
int begin_step(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work, Timing& timing) {
  using H = Heading;
  StepState* const state = work.state.data();
  const bool mixture = scene.seepage.mixture;
  bool walls_turned = false;  // started or stopped
  if (scene.has_moving_walls) {
    timing.time(H::move_walls, [&] {
      const bool moving = hold_walls(on, p, scene, work.motions, work.time);
      walls_turned = moving != work.walls_moving;
      work.walls_moving = moving;
    });
  }
  timing.time(H::apply_equation_of_state, [&] {
    mixture ? apply_mixture_state(on, p, scene, work.mixture) : apply_equation_of_state(on, p, scene);
  });
  // Pore pressure takes from the weight in every step.
  if ((work.new_lists || scene.seepage.pore_pressure) && scene.has_sediment) {
    timing.time(H::weigh_sediment, [&] { weigh_sediment(on, p, scene, work.weight); });
  }
  if ((work.new_lists || walls_turned) && scene.may_rest) {
    timing.time(H::update_rest, [&] { list_active_clusters(on, p); });
  }
  timing.time(H::extrapolate_to_walls, [&] {
    if (p.any_resting) extrapolate_to_resting(on, p, scene);
    mixture ? extrapolate_mixture_to_walls(on, p, scene) : extrapolate_to_walls(on, p, scene);
  });
  int pressure_sweeps = 0;
  if (scene.has_sediment) {
    timing.time(H::apply_rheology, [&] {
      pressure_sweeps = solve_effective_pressure(on, p, scene);
      apply_rheology(on, p, scene);
    });
  }
  timing.time(H::compute_accelerations, [&] {
    mixture ? compute_mixture_accelerations(on, p, scene, work.mixture) : compute_accelerations(on, p, scene);
  });
  timing.time(H::stable_time_step, [&] { stable_time_step(on, p, scene, state); });
  on.only_if(&state->go);
  if (scene.two_pass) evaluate_half_way(on, p, scene, work, timing);
  timing.time(H::kick, [&] { kick(on, p, state); });
  if (scene.has_sediment && scene.has_moving_walls) {  // viscosity drags at the velocity the walls go with
    timing.time(H::move_walls, [&] { move_walls(on, p, scene, work.motions, work.time, on.look(&state->step.dt), 0); });
  }
  if (scene.has_sediment) {
    timing.time(H::solve_viscosity, [&] { begin_viscosity(on, p, scene, work.mixture, work.viscous, state); });
  }
  on.only_if(nullptr);
  return pressure_sweeps;
}

/// The rest of the step, unless the run has diverged or the viscous part is not at its end.
template <int Dim, class Device>
void end_step(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work, Timing& timing) {
  using H = Heading;
  StepState* const state = work.state.data();
  const bool mixture = scene.seepage.mixture;
  if (scene.has_sediment) {
    timing.time(H::solve_viscosity, [&] { end_viscosity(on, p, scene, work.viscous, state); });
  }
  on.only_if(&state->moves);
  const double dt_of_walls = scene.has_moving_walls ? on.look(&state->step.dt) : 0;  // viscosity may have shortened it
  const auto move_walls_by = [&](double share) {
    if (!scene.has_moving_walls) return;
    timing.time(H::move_walls, [&] { move_walls(on, p, scene, work.motions, work.time, dt_of_walls, share); });
  };
  if (scene.two_pass) {
    timing.time(H::drift, [&] { go_all_the_way(on, p, scene, state, work.start); });
  } else {
    timing.time(H::drift, [&] { drift(on, p, scene, state, 0.5); });
    move_walls_by(0.5);
    timing.time(H::compute_density_rates, [&] {
      mixture ? compute_mixture_density_rates(on, p, scene, work.mixture) : compute_density_rates(on, p, scene);
    });
    timing.time(H::update_density, [&] { update_density(on, p, state); });
    timing.time(H::drift, [&] { drift(on, p, scene, state, 0.5); });
    move_walls_by(1);
  }
  if (scene.seepage.pore_pressure) {
    timing.time(H::advance_pore_pressure,
                [&] { advance_pore_pressure(on, p, scene, work.pore_diffusion, state, longest_stable_step(scene)); });
  }
  if (scene.has_states) {
    timing.time(H::update_bed_states, [&] {
      if (work.new_lists) clear_bed_surface(on, p);
      update_bed_states(on, p, scene, state);
    });
  }
  if (scene.may_rest) {
    timing.time(H::update_rest, [&] {
      if (work.walls_moving) wake_beside_moving_walls(on, p, scene, state);
      update_rest(on, p, scene, state);
    });
  }
  timing.time(H::refresh_neighbours, [&] { neighbours::find_squared_drift(on, p, scene, state); });
  on.only_if(nullptr);
}

/// What the launches of a step depend on beside numbers on the device; 0 where that is something else every time, or
/// the host has to look at the device meanwhile. The first step with new lists is one of those, and grows the buffers
/// that later ones use.
template <int Dim, class Device>
std::uint64_t launches_key(const Particles<Device>& p, const Scene<Dim>& scene, const Workspace<Device>& work,
                           int iterations, const Timing& timing) {
  constexpr Index most_particles = 500000;  // with more, launching is quick beside what is launched
  const bool varies = work.new_lists || work.lists != work.lists_before || scene.has_moving_walls ||
                      scene.sediment.effective_pressure == EffectivePressure::laplace || timing.waits();
  if (varies || p.count > most_particles) return 0;
  return work.lists << 20 | static_cast<std::uint64_t>(iterations);
}

/// THE algorithm: one step in time, at most `longest` seconds. The host hands all of it to the device and waits once,
/// at the end: for what came of it, and whether lists have to be made anew before the next.
template <int Dim, class Device>
StepResult advance(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work, double longest,
                   Timing& timing) {
  StepResult result;
  timing.time(Heading::refresh_neighbours, [&] { result.excluded = refresh_neighbours(on, p, scene, work); });
  StepState* const state = work.state.data();
  StepState now;
  now.longest = longest;
  on.send(now, state);

  // A device that works ahead of the host is given a few iterations more than the last step took, in fours, so that
  // the launches are often the same.
  const int ahead = Device::is_host ? scene.viscous_iterations : std::min(work.viscous_iterations / 4 * 4 + 4, 1000);
  const auto iterate_and_end = [&] {
    if (scene.has_sediment) {
      timing.time(Heading::solve_viscosity, [&] { iterate_viscosity(on, p, scene, work.viscous, state, ahead); });
    }
    end_step(on, p, scene, work, timing);
  };
  on.repeat(launches_key(p, scene, work, ahead, timing), [&] {
    result.pressure_sweeps = begin_step(on, p, scene, work, timing);
    iterate_and_end();
  });
  work.lists_before = work.lists;
  now = on.look(state);
  int iterations = 0;  // of solves that failed
  while (now.viscous.running != 0 || viscosity::may_retry(now.viscous, result.viscous.retries)) {
    if (now.viscous.running == 0) {
      iterations += now.viscous.iterations;
      viscosity::prepare_retry(on, p, state, result.viscous.retries > 0);
      begin_viscosity(on, p, scene, work.mixture, work.viscous, state);
      ++result.viscous.retries;
    }
    iterate_and_end();
    now = on.look(state);
  }
  if (now.woken + now.stopped > 0) {
    timing.time(Heading::update_rest, [&] { list_active_clusters(on, p); });
    ++work.lists;
  }
  work.new_lists = false;
  work.squared_drift = now.squared_drift;
  work.viscous_iterations = now.viscous.iterations;
  result.step = now.step;
  result.viscous.iterations = iterations + now.viscous.iterations;
  result.viscous.residual = now.viscous.residual;
  result.viscous.converged = now.viscous.converged != 0;
  result.viscous.capped = now.capped;
  return result;
}

}  // namespace thalweg
