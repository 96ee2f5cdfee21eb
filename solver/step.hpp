#pragma once

#include <optional>
#include <vector>

#include "solver/lists/rebuild.hpp"
#include "solver/models/all.hpp"
#include "solver/passes/integrate.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/pressure.hpp"
#include "solver/passes/time_step.hpp"
#include "solver/timing.hpp"

// THE algorithm. What stands here is the water and the order of the stages; models take part in the stages, or take
// them over (models/stages.hpp).
namespace thalweg {

/// The context of a step: the stages work with its members.
template <int Dim, class Device>
struct Step {
  static constexpr int dimension = Dim;
  using OnDevice = Device;

  Device& on;
  Particles<Device>& p;
  const Scene<Dim>& scene;
  Workspace<Device>& work;
  Timing& timing;
  StepState* state = nullptr;  // on the device
  StepState now = {};          // on the host, as last written or read

  template <class What>
  void time(const char* heading, const What& what) {
    timing.time(heading, what);
  }
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

/// Takes out particles that have left the domain and makes new lists, if particles have drifted half the skin.
template <int Dim, class Device>
std::vector<ExcludedParticle> refresh_neighbours(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                                 Workspace<Device>& work) {
  work.state.resize(1);
  if (!work.squared_drift && p.has_lists()) {
    neighbours::find_squared_drift(on, p, scene, work.state.data());
    work.squared_drift = on.read(work.state.data()).squared_drift;
  }
  if (p.has_lists() && !must_rebuild_lists(scene, *work.squared_drift)) return {};
  if (p.has_lists()) AllModels::before_lists(on, p, scene, work);
  auto excluded = rebuild_lists(on, p, scene, work.population);
  work.new_lists = true;
  work.squared_drift = 0;
  ++work.list_rebuilds;
  ++work.lists;
  return excluded;
}

/// Chooses the step; where the run has diverged nothing more goes on.
template <int Dim, class Device>
void stable_time_step(Step<Dim, Device>& s) {
  StepState* const state = s.state;
  const Scene<Dim> scene = s.scene;
  s.on.for_each(1, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index) {
                  choose_water_step(scene, *state);
                  AllModels::limit(scene, *state);
                  state->go = state->moves = has_diverged(state->step.extremes) ? 0 : 1;
                  land_on_output(state->step, state->longest);
                }));
}

/// The step up to the implicit part of its velocities.
template <int Dim, class Device>
void begin_step(Step<Dim, Device>& s) {
  auto& on = s.on;
  auto& p = s.p;
  const auto& scene = s.scene;
  AllModels::all<stage::AtStart>(s);
  AllModels::first<stage::AtState>(s, [&] { apply_equation_of_state(on, p, scene); });
  AllModels::all<stage::AtLists>(s);
  AllModels::all<stage::AtBoundaries>(s);
  AllModels::first<stage::AtWalls>(s, [&] { extrapolate_to_walls(on, p, scene); });
  AllModels::all<stage::AtStrength>(s);
  AllModels::first<stage::AtForces>(s, [&] { compute_accelerations(on, p, scene); });
  AllModels::all<stage::AddForces>(s);
  s.time("stable_time_step", [&] { find_extremes(on, p, s.state); });
  AllModels::all<stage::FindLimits>(s);
  s.time("stable_time_step", [&] { stable_time_step(s); });
  on.skip_unless(&s.state->go);
  s.time("kick", [&] { kick(on, p, s.state); });
  AllModels::all<stage::BeginImplicit>(s);
  on.skip_unless(nullptr);
}

/// Places and densities, by leapfrog.
template <int Dim, class Device>
void move_by_leapfrog(Step<Dim, Device>& s) {
  auto& on = s.on;
  auto& p = s.p;
  const auto& scene = s.scene;
  s.time("drift", [&] { drift(on, p, scene, s.state, 0.5); });
  AllModels::all<stage::AtHalfWay>(s);
  AllModels::first<stage::AtRates>(s, [&] { compute_density_rates(on, p, scene); });
  AllModels::all<stage::AddRates>(s);
  s.time("drift", [&] { update_density_and_drift(on, p, scene, s.state, 0.5); });
  AllModels::all<stage::AtArrival>(s);
}

/// The rest of the step, unless the run has diverged or the implicit part is not at its end.
template <int Dim, class Device>
void end_step(Step<Dim, Device>& s) {
  AllModels::all<stage::IterateImplicit>(s);
  AllModels::all<stage::EndImplicit>(s);
  s.on.skip_unless(&s.state->moves);
  AllModels::all<stage::BeforeMotion>(s);
  move_by_leapfrog(s);
  AllModels::all<stage::AfterStep>(s);
  s.time("refresh_neighbours", [&] { neighbours::find_squared_drift(s.on, s.p, s.scene, s.state); });
  s.on.skip_unless(nullptr);
}

/// The key of a step's launches: equal keys mean equal launches but for numbers on the device. 0 if they differ every
/// time, or if the host has to read from the device meanwhile. The first step with new lists has 0, and grows the
/// buffers that later steps use.
template <int Dim, class Device>
std::uint64_t launches_key(Step<Dim, Device>& s) {
  const bool varies =
      s.work.new_lists || s.work.lists != s.work.lists_before || AllModels::vary(s.scene) || s.timing.waits();
  if (varies) return 0;
  return s.work.lists << 20 | static_cast<std::uint64_t>(ViscosityModel::iterations_handed_over(s));
}

/// True if it pays to hand over launches as one: with more particles launching is quick beside what is launched.
inline bool pays_to_repeat(Index particles) { return particles <= 500000; }

/// One step in time, at most `longest` seconds. The host hands all of it to the device and waits once, at the end: for
/// what came of it, and whether lists have to be made anew before the next.
template <int Dim, class Device>
StepResult advance(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace<Device>& work, double longest,
                   Timing& timing) {
  StepResult result;
  timing.time("refresh_neighbours", [&] { result.excluded = refresh_neighbours(on, p, scene, work); });
  Step<Dim, Device> s{on, p, scene, work, timing, work.state.data(), {}};
  s.now.longest = longest;
  s.now.number = work.number;
  on.write(s.now, s.state);
  const std::uint64_t key = launches_key(s);
  work.launches.note(key);
  on.repeat(pays_to_repeat(p.count) ? key : 0, [&] {
    begin_step(s);
    end_step(s);
  });
  work.lists_before = work.lists;
  s.now = on.read(s.state);
  ViscosityModel::finish(s, [&] { end_step(s); });
  AllModels::all<stage::AfterReading>(s);
  ++work.number;
  work.new_lists = false;
  work.squared_drift = s.now.squared_drift;
  result.step = s.now.step;
  result.viscous = work.viscous_result;
  result.pressure_sweeps = work.pressure_sweeps;
  return result;
}

}  // namespace thalweg
