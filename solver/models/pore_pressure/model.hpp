#pragma once

#include "solver/models/pore_pressure/pore_pressure.hpp"
#include "solver/models/pore_pressure/scene.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

struct SceneSource;

template <class Device>
struct PorePressureWork {
  PoreDiffusion<Device> pore_diffusion;

  [[nodiscard]] std::size_t bytes() const {
    return (pore_diffusion.loss.size() + pore_diffusion.before.size()) * sizeof(float);
  }
};

/// Excess pore pressure in a bed of one fluid.
struct PoreModel {
  template <int Dim>
  using Parameters = PorePressureScene<Dim>;
  template <class Device>
  using Arrays = PorePressureArrays<Device>;
  template <class Device>
  using Work = PorePressureWork<Device>;
  static constexpr const char* heading = "advance_pore_pressure";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.pores.on;
  }
  template <class C>
  static void after_step(C& step) {
    advance_pore_pressure(step.on, step.p, step.scene, step.work.pore_diffusion, step.state,
                          longest_stable_step(step.scene));
  }
};

}  // namespace thalweg
