#pragma once

#include "solver/models/no_slip/scene.hpp"
#include "solver/models/no_slip/wall_drag.hpp"

namespace thalweg {

struct SceneSource;

/// Water that sticks to walls, for laminar flow.
struct NoSlipModel {
  template <int Dim>
  using Parameters = NoSlipScene<Dim>;
  static constexpr const char* heading = "add_forces";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.water_sticks;
  }
  template <class C>
  static void add_forces(C& step) {
    add_wall_drag(step.on, step.p, step.scene);
  }
};

}  // namespace thalweg
