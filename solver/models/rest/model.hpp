#pragma once

#include "solver/models/rest/rest.hpp"
#include "solver/models/rest/scene.hpp"

namespace thalweg {

struct SceneSource;

/// Deposits that come to rest and cost next to nothing until something wakes them.
struct RestModel {
  template <int Dim>
  using Parameters = RestScene<Dim>;
  template <class Device>
  using Arrays = RestArrays<Device>;
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
    update_rest(step.on, step.p, step.scene, step.state);
  }
  template <class C>
  static void after_reading(C& step) {
    if (step.now.woken + step.now.stopped == 0) return;
    list_active_clusters(step.on, step.p);
    ++step.work.lists;
  }
};

}  // namespace thalweg
