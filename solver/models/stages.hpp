#pragma once

#include <type_traits>

#include "physics/host_device.hpp"

// The stages of a step (step.hpp) and how models take part in them. A model is a struct of static functions; it offers
// the stages it needs and nothing else. Stages of the first kind run for every model that is on and offers them, in the
// order of the list (models/all.hpp). Stages of the second kind are done by one: the first model that is on and offers
// the stage, or the water.
namespace thalweg {

/// True if model M offers a stage to a step C.
template <class Stage, class M, class C>
concept Offers = requires(C& step) {
  Stage::template run<M>(step);
};

namespace stage {

// The first kind: all models.

/// Before everything else of a step.
struct AtStart {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_start(step)) {
    return M::at_start(step);
  }
};
/// Only if M::lists_due(step): after the neighbour lists were made, or where something else makes lists stale.
struct AtLists {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_lists(step)) {
    return M::at_lists(step);
  }
};
/// Pressure of what stands in for the fluid's continuation, before the walls'.
struct AtBoundaries {
  static constexpr const char* heading = "extrapolate_to_walls";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_boundaries(step)) {
    return M::at_boundaries(step);
  }
};
/// Effective pressure, yield stress, viscosity.
struct AtStrength {
  static constexpr const char* heading = "apply_rheology";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_strength(step)) {
    return M::at_strength(step);
  }
};
/// After the explicit accelerations: terms of models, added to them.
struct AddForces {
  static constexpr const char* heading = "add_forces";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::add_forces(step)) {
    return M::add_forces(step);
  }
};
/// Finds what bounds the step; M::limit_step(scene, state) then shortens it, on the device.
struct FindLimits {
  static constexpr const char* heading = "stable_time_step";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::find_limits(step)) {
    return M::find_limits(step);
  }
};
/// After the explicit velocities: terms that are solved for implicitly begin, go on, and end.
struct BeginImplicit {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::begin_implicit(step)) {
    return M::begin_implicit(step);
  }
};
struct IterateImplicit {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::iterate_implicit(step)) {
    return M::iterate_implicit(step);
  }
};
struct EndImplicit {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::end_implicit(step)) {
    return M::end_implicit(step);
  }
};
/// Before, half-way through and at the end of the motion.
struct BeforeMotion {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::before_motion(step)) {
    return M::before_motion(step);
  }
};
struct AtHalfWay {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_half_way(step)) {
    return M::at_half_way(step);
  }
};
/// After the density rates: terms of models, added to them.
struct AddRates {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::add_rates(step)) {
    return M::add_rates(step);
  }
};
struct AtArrival {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_arrival(step)) {
    return M::at_arrival(step);
  }
};
/// After the motion.
struct AfterStep {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::after_step(step)) {
    return M::after_step(step);
  }
};
/// On the host, after it has read the state of the step (step.now).
struct AfterReading {
  template <class M, class C>
  static auto run(C& step) -> decltype(M::after_reading(step)) {
    return M::after_reading(step);
  }
};

// The second kind: one model, or the water.

/// Pressure and volume from density.
struct AtState {
  static constexpr const char* heading = "apply_equation_of_state";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_state(step)) {
    return M::at_state(step);
  }
};
/// Pressure of the walls.
struct AtWalls {
  static constexpr const char* heading = "extrapolate_to_walls";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_walls(step)) {
    return M::at_walls(step);
  }
};
/// Explicit accelerations.
struct AtForces {
  static constexpr const char* heading = "compute_accelerations";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_forces(step)) {
    return M::at_forces(step);
  }
};
/// Density rates.
struct AtRates {
  static constexpr const char* heading = "compute_density_rates";
  template <class M, class C>
  static auto run(C& step) -> decltype(M::at_rates(step)) {
    return M::at_rates(step);
  }
};

}  // namespace stage

/// The heading under which a stage of a model is timed: the stage's, or else the model's.
template <class Stage, class M>
constexpr const char* heading_of() {
  if constexpr (requires { Stage::heading; }) {
    return Stage::heading;
  } else {
    return M::heading;
  }
}

/// A list of models, known at compile time.
template <class... Models>
struct ModelList {
  /// Runs a stage of the first kind.
  template <class Stage, class C>
  static void all(C& step) {
    (one<Stage, Models>(step), ...);
  }

  /// Runs a stage of the second kind; water() where no model takes it.
  template <class Stage, class C, class Water>
  static void first(C& step, const Water& water) {
    if (!(taken<Stage, Models>(step) || ...)) step.time(Stage::heading, water);
  }

  /// Calls M::before_lists(on, p, scene, work) of every model that is on and offers it: before the lists are made anew,
  /// where particles may become of another kind, and are born and die. The old lists still stand.
  template <class Device, class Particles, class Scene, class Workspace>
  static void before_lists(Device& on, Particles& p, const Scene& scene, Workspace& work) {
    (one_before_lists<Models>(on, p, scene, work), ...);
  }

  /// Calls visit.template operator()<M>() for every model.
  template <class Visit>
  static void each(const Visit& visit) {
    (visit.template operator()<Models>(), ...);
  }

  /// Shortens the step by what models have found; on the device.
  template <class Scene, class State>
  HOST_DEVICE static void limit(const Scene& scene, State& state) {
    (limit_by<Models>(scene, state), ...);
  }

  /// True if a model's launches differ from step to step.
  template <class Scene>
  static bool vary(const Scene& scene) {
    return (varies<Models>(scene) || ...);
  }

 private:
  template <class Stage, class M, class C>
  static void one(C& step) {
    if constexpr (Offers<Stage, M, C>) {
      if (!M::is_on(step.scene)) return;
      if constexpr (std::is_same_v<Stage, stage::AtLists>) {
        if (!M::lists_due(step)) return;
      }
      step.time(heading_of<Stage, M>(), [&] { Stage::template run<M>(step); });
    }
  }

  template <class M, class Device, class Particles, class Scene, class Workspace>
  static void one_before_lists(Device& on, Particles& p, const Scene& scene, Workspace& work) {
    if constexpr (requires { M::before_lists(on, p, scene, work); }) {
      if (M::is_on(scene)) M::before_lists(on, p, scene, work);
    }
  }

  template <class Stage, class M, class C>
  static bool taken(C& step) {
    if constexpr (Offers<Stage, M, C>) {
      if (!M::is_on(step.scene)) return false;
      step.time(Stage::heading, [&] { Stage::template run<M>(step); });
      return true;
    } else {
      return false;
    }
  }

  template <class M, class Scene, class State>
  HOST_DEVICE static void limit_by(const Scene& scene, State& state) {
    if constexpr (requires { M::limit_step(scene, state); }) {
      if (M::is_on(scene)) M::limit_step(scene, state);
    }
  }

  template <class M, class Scene>
  static bool varies(const Scene& scene) {
    if constexpr (requires { M::varies(scene); }) {
      return M::is_on(scene) && M::varies(scene);
    } else {
      return false;
    }
  }
};

}  // namespace thalweg
