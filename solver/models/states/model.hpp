#pragma once

#include "solver/models/states/bed_states.hpp"
#include "solver/models/states/scene.hpp"

namespace thalweg {

struct SceneSource;

/// Sediment in three states: deposit, bed load, suspended.
struct StatesModel {
  template <int Dim>
  using Parameters = StatesScene<Dim>;
  template <class Device>
  using Arrays = StatesArrays<Device>;
  static constexpr const char* heading = "update_bed_states";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_states;
  }
  template <class C>
  static void after_step(C& step) {
    if (step.work.new_lists) clear_bed_surface(step.on, step.p);
    update_bed_states(step.on, step.p, step.scene, step.state);
  }
};

}  // namespace thalweg
