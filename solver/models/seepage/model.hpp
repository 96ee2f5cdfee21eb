#pragma once

#include "solver/models/seepage/buoyancy.hpp"
#include "solver/models/seepage/coupling.hpp"
#include "solver/models/seepage/porosity.hpp"
#include "solver/models/seepage/scene.hpp"
#include "solver/models/seepage/volume_flux.hpp"
#include "solver/models/seepage/wall_pressure.hpp"

namespace thalweg {

struct SceneSource;

/// Grains and pore water as two sets of particles in the same places. Its passes take the place of the water's.
struct MixtureModel {
  template <int Dim>
  using Parameters = SeepageScene<Dim>;
  template <class Device>
  using Arrays = SeepageArrays<Device>;

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.seepage.mixture;
  }
  template <class C>
  static void at_state(C& step) {
    apply_mixture_state(step.on, step.p, step.scene);
  }
  template <class C>
  static void at_walls(C& step) {
    extrapolate_mixture_to_walls(step.on, step.p, step.scene);
  }
  template <class C>
  static void at_forces(C& step) {
    compute_mixture_accelerations(step.on, step.p, step.scene);
  }
  template <class C>
  static void at_rates(C& step) {
    compute_mixture_density_rates(step.on, step.p, step.scene);
  }
};

}  // namespace thalweg
