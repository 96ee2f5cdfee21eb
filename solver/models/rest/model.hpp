#pragma once

#include <cstdint>

#include "common/particles.hpp"
#include "solver/models/rest/rest.hpp"
#include "solver/models/rest/scene.hpp"

namespace thalweg {

struct SceneSource;

/// State that the model keeps between steps, on the host.
template <class Device>
struct RestWork {
  std::int64_t rest_changed = 0;  // number of the step before which particles last could stop and wake
};

/// Deposits that come to rest and cost next to nothing until something wakes them.
struct RestModel {
  template <int Dim>
  using Parameters = RestScene<Dim>;
  template <class Device>
  using Arrays = RestArrays<Device>;
  template <class Device>
  using Work = RestWork<Device>;
  static constexpr const char* heading = "update_rest";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.may_rest;
  }
  template <class C>
  static bool lists_due(C& step) {
    return step.work.new_lists || step.work.walls_turned;
  }
  template <class C>
  static void at_lists(C& step) {
    list_active_clusters(step.on, step.p);
  }
  template <class C>
  static void at_boundaries(C& step) {
    if (step.p.any_resting) extrapolate_to_resting(step.on, step.p, step.scene);
  }
  template <class C>
  static void after_step(C& step) {
    if (step.work.walls_moving) wake_beside_moving_walls(step.on, step.p, step.scene, step.state);
    find_calm(step.on, step.p, step.scene, step.state);
  }
  template <class Device, class Scene, class Workspace>
  static void before_lists(Device& on, Particles<Device>& p, const Scene& scene, Workspace& work) {
    wake_and_stop(on, p, scene);
    work.rest_changed = work.number;
  }
  template <class C>
  static void after_reading(C& step) {
    auto& work = step.work;
    bool changed = step.now.woken > 0;
    if (step.now.waiting > 0 && work.number - work.rest_changed >= rest::most_steps) {
      changed = wake_and_stop(step.on, step.p, step.scene) > 0 || changed;
      work.rest_changed = work.number;
    }
    if (!changed) return;
    list_active_clusters(step.on, step.p);
    ++work.lists;
  }
};

/// Name of the step of the last change in a checkpoint (ParticleSet::facts).
inline constexpr const char* rest_fact = "RestChanged";

template <class Device>
void load_rest(RestWork<Device>& work, const ParticleSet& from) {
  const auto known = from.facts.find(rest_fact);
  if (known != from.facts.end()) work.rest_changed = static_cast<std::int64_t>(known->second.at(0));
}
template <class Device>
void add_rest(const RestWork<Device>& work, ParticleSet& to) {
  to.facts[rest_fact] = {static_cast<double>(work.rest_changed)};
}

}  // namespace thalweg
