#pragma once

#include "solver/models/sub_particle/arrays.hpp"
#include "solver/models/sub_particle/stress_sweep.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

struct SceneSource;

/// Stress in the water by eddies smaller than the particles: model.turbulence = "sps".
struct SubParticleModel {
  template <int Dim>
  using Parameters = SubParticleScene<Dim>;
  template <class Device>
  using Arrays = SubParticleArrays<Device>;

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.sub_particle_stress;
  }
  template <class C>
  static void add_forces(C& step) {
    add_sub_particle_stress(step.on, step.p, step.scene);
  }

  template <class C>
  static void find_limits(C& step) {
    const SubParticle* sub_particle = step.p.sub_particle.data();
    find_largest_eddy_viscosity(step.on, step.p.fluid_count,
                                declare<Reads<field::sub_particle>, Writes<>>(
                                    [=] HOST_DEVICE(Index i) { return sub_particle[i].eddy_viscosity; }),
                                step.state);
  }
  /// Binds only if velocities between neighbours differ by many times the sound speed.
  template <class Scene>
  HOST_DEVICE static void limit_step(const Scene& scene, StepState& state) {
    limit_by_eddies(scene, state);
  }
};

}  // namespace thalweg
