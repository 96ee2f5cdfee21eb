#pragma once

#include <cmath>

#include "solver/models/shifting/scene.hpp"
#include "solver/models/shifting/shifting.hpp"

namespace thalweg {

struct SceneSource;

/// Shifting of the water's particles, after the motion.
struct ShiftingModel {
  template <int Dim>
  using Parameters = ShiftingScene<Dim>;
  static constexpr const char* heading = "shift_particles";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_shifting;
  }
  template <class C>
  static void after_step(C& step) {
    shift_particles(step.on, step.p, step.scene, step.state);
  }
};

/// Turns the shifting of a scene on.
template <int Dim>
void use_shifting(Scene<Dim>& scene) {
  scene.has_shifting = true;
  scene.shifting_interval = shifting::interval;
  scene.shifting_keeps_level = dot(scene.gravity, scene.gravity) > 0;
  scene.pressing = dot(scene.gravity, scene.gravity) > 0 ? 0 : INFINITY;
  const auto& kernel = scene.kernel;
  scene.inverse_spacing_kernel = 1 / kernel.value(kernel.closeness(static_cast<float>(scene.spacing)));
}

}  // namespace thalweg
